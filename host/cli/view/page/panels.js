// What stands beside the path: tools, messages, differences, what a line does. All text of a program is set as text.

export const element = (name, properties = {}, ...children) => {
  const out = Object.assign(document.createElement(name), properties);
  out.append(...children);
  return out;
};

export const number = (value, digits = 3) => {
  const text = value.toFixed(digits);
  return text === `-${(0).toFixed(digits)}` ? text.slice(1) : text;
};

const thousands = (value) => value.toLocaleString('en-US');

export const duration = (seconds) => {
  if (seconds < 60) return `${number(seconds, 1)} s`;
  const whole = Math.round(seconds), minutes = Math.floor(whole / 60) % 60;
  return seconds < 3600 ? `${minutes} min ${whole % 60} s` : `${Math.floor(whole / 3600)} h ${minutes} min`;
};

export const toolName = (tool) => tool.number === 0 ? 'No tool called' : `T${tool.number} ${tool.name}`.trim();

// A choice for each tool that moves; `change(path, tool, isShown)`.
export const fillTools = (list, paths, isDark, change) => {
  for (const [side, path] of paths.entries()) {
    if (paths.length > 1) list.append(element('h2', { textContent: path.dialect }));
    for (const [index, tool] of path.tools.entries()) {
      if (!tool.moves) continue;
      const box = element('input', { type: 'checkbox', checked: true });
      box.addEventListener('change', () => change(side, index, box.checked));
      const swatch = element('i', { className: 'swatch' });
      swatch.style.background = tool.colour[isDark ? 1 : 0];
      list.append(element('li', {}, element('label', { className: 'choice' }, box, swatch, toolName(tool),
        element('small', { textContent: `${thousands(tool.moves)} moves` }))));
    }
  }
};

export const timesText = (path) => {
  const parts = [`Rapid ${duration(path.rapidSeconds)}`, `feed ${duration(path.feedSeconds)}`];
  if (path.dwellSeconds > 0) parts.push(`dwell ${duration(path.dwellSeconds)}`);
  let text = `${parts.join(', ')}; no accelerations.`;
  if (path.assumedRapids) text += ' The machine declares no rapid rate: 10,000 mm/min and 60 deg/s are assumed.';
  if (path.assumedFeeds) text += ` ${thousands(path.assumedFeeds)} moves have no feed rate: 1,000 mm/min is assumed.`;
  if (path.isCut) text += ' The program has more moves than this page holds.';
  return text;
};

export const kinematicsText = (path) => {
  if (!path.kinematics)
    return path.turnsAxes
      ? 'The program turns rotary axes, but this dialect has no MachineKinematics: the path shows X Y Z of the machine, ' +
        'and the angles are numbers. A machine with its kinematics (-m) shows the part and the tool turning.'
      : '';
  const tables = path.kinematics.tables.map((table) => 'ABC'[table.axis]);
  const heads = [...path.kinematics.axes].filter((axis) => !tables.includes(axis));
  return `Machine: ${[...tables.map((axis) => `table ${axis}`), ...heads.map((axis) => `head ${axis}`)].join(', ')}.` +
    (tables.length ? ' Off: the part rests, and the tool moves around it.' : ' The head turns the tool; the part rests.');
};

const placeOf = (facts, report) => {
  const file = report.file === null || report.file === undefined ? '' : facts.files.length > 1 ? `${facts.files[report.file]}, ` : '';
  const side = facts.paths.length > 1 && report.path !== undefined ? `${facts.paths[report.path].dialect}, ` : '';
  return side + (report.line ? `${file}line ${report.line}` : 'whole program');
};

const listItem = (facts, report, children, choose) => {
  const item = element('li', {}, element('span', { className: 'place', textContent: placeOf(facts, report) }), ...children);
  if (report.line && report.file !== null && report.file !== undefined) {
    item.dataset.line = report.line;
    item.addEventListener('click', () => choose(report.file, report.line));
  }
  return item;
};

const reportTexts = (report) => [
  element('b', { className: report.severity, textContent: report.severity }), `: ${report.message} `,
  element('small', { textContent: `[${report.code}]` }),
  ...(report.hint ? [element('br'), element('small', { textContent: `→ ${report.hint}` })] : []),
];

export const fillReports = (list, facts, choose) => {
  for (const report of facts.diagnostics) list.append(listItem(facts, report, reportTexts(report), choose));
  const more = facts.reported - facts.diagnostics.length;
  if (more > 0) list.append(element('li', { textContent: `${thousands(more)} more are not listed; isogloss run lists all.` }));
  if (!facts.reported) list.append(element('li', { textContent: 'Nothing was reported.' }));
};

export const fillDifferences = (list, facts, choose) => {
  const names = facts.paths.map((path) => path.dialect).join(' / ');
  list.append(element('li', { textContent: facts.differences.length
    ? `Machine positions and feeds, ${names}. isogloss diff says why they part.` : 'Both sides move alike.' }));
  for (const one of facts.differences) list.append(listItem(facts, one, [one.what], choose));
};

// What a line does: from the page, or from the command that serves it.
export const explanationOf = async (facts, side, file, line) => {
  const stored = facts.explanations?.[side]?.[file];
  if (stored) return stored[line] ?? '';
  if (facts.version === null)
    return `The program has more than ${thousands(facts.explainedLines)} lines, which this page does not explain: ` +
      'isogloss view --serve does, and isogloss explain PROGRAM:LINE.';
  const response = await fetch(`/explain?path=${side}&file=${file}&line=${line}`);
  return response.ok ? response.text() : 'The command that served this page does not answer.';
};

export const explanationElements = (facts, file, line, sentences) => {
  const heading = `${facts.files.length > 1 ? `${facts.files[file]}, ` : ''}line ${line}`;
  const out = [element('h2', { textContent: heading })];
  sentences.forEach((sentence, side) => {
    const name = facts.paths.length > 1 ? `${facts.paths[side].dialect}: ` : '';
    out.push(element('p', { textContent: name + (sentence || 'The run has no block at this line.') }));
  });
  for (const report of facts.diagnostics)
    if (report.file === file && report.line === line)
      out.push(element('p', { className: `report ${report.severity}` }, ...reportTexts(report)));
  return out;
};

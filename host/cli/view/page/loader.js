// Starts the modules of the page. They stand in it as text, each behind those that it imports; each becomes a blob, so
// that one file works from a disk and the security policy need not allow anything else.
(async () => {
  const addresses = {};
  const addressOf = (name) => addresses[name === 'three' ? 'three.module.min.js' : name.split('/').pop()];
  for (const script of document.querySelectorAll('script[data-module]')) {
    const text = script.textContent.replace(
      /(\bfrom\s*|\bimport\s*)(['"])([^'"\n]+)\2/g,
      (whole, keyword, quote, name) => addressOf(name) ? `${keyword}${quote}${addressOf(name)}${quote}` : whole);
    addresses[script.dataset.module] = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    script.remove();
  }
  const { start } = await import(addresses['main.js']);
  start();
})().catch((error) => {
  console.error(error);
  document.body.dataset.state = 'failed';
  document.getElementById('failure').textContent = `The page could not be shown: ${error.message}`;
});

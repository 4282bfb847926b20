// A vendor's plugin for `isogloss docs`: each text of it would harm a page that took it as it is.
#include <isogloss/sdk.hpp>

namespace {

constexpr const char* page = R"PAGE(# VendorPressSyntax

M181 presses <script>alert("page")</script> and <img src=x onerror=alert(1)>, as [DwellSyntax](dwell_syntax.md) waits.
See PeckDrillingCycleSyntax, `Dwell.Time`, `G83`, ISO-0302, and [the notes](#notes).

[bad](javascript:alert(1)) [hidden](javascript&#58;alert(2)) [missing](no_such_page.md) [own](vendor_press_syntax.md#notes)
[web](https://example.com/a?b=1&c="2") ![picture](https://example.com/picture.png) <https://example.com/auto>

<div onclick="alert(3)">
a block
</div>

| column | other |
|---|---|
| `a` | <b>bold</b> |

```xml
<Tool id="1"/>
```

## Notes

&lt;kept&gt; &amp; so on

## Presses

#Dependencies:

```xml
<VendorPressSyntax force="2"/>
```

#BeforeBuild:

```json
{
  "Parsing": { "Flags": ["M181"] },
  "Kept": { "Value": "</script><script>alert(4)</script>" }
}
```

#AfterBuild:

```json
{
  "Kept": { "Value": "</script><script>alert(4)</script>" },
  "VendorPress": { "IsDown": true }
}
```

#Diagnostics:

```
VEN-0001
```

## Any code

#BeforeBuild:

```json
{}
```

#AfterBuild:

```json
{}
```

#Diagnostics: any
)PAGE";

constexpr const char* cases =
    "# VendorPressSyntax\n\nSee [its page](vendor_press_syntax.md).\n\n## Nothing\n\n"
    "#BeforeBuild:\n\n```json\n{}\n```\n\n#AfterBuild:\n\n```json\n{}\n```\n";

constexpr ig::EmbeddedDiagnostic explanation{"VEN-0001", "Explained <i>here</i> & there.", "M181 ` <u>"};

struct VendorPress {
  static constexpr auto spec = ig::syntax("VendorPressSyntax", "M181 <b>presses</b> | see PeckDrillingCycleSyntax.");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "VEN-0001", "pressed </p><script>alert(5)</script> '{0}'"),
  };
  enum class Side { left, right };

  ig::Codes codes_{"M181"};
  ig::Out<bool> is_down_{"VendorPress.IsDown", {ig::Life::modal, "", "Down <em>now</em>."}};
  ig::NumberOption force_{"force", "1", {0.5, 40}, "kN", "Force <s>of</s> the press."};
  ig::Choice<Side> side_{"side", "left|right", "left", "Side of the press."};

  ig::Status build(ig::Block& block) const {
    if (!block.take(codes_)) return ig::Status::unchanged;
    block.report(ig::diag("VEN-0001"), ig::Where::block());
    block.set(is_down_, true);
    return ig::Status::changed;
  }
};

const ig::Register<VendorPress> vendor_press;

}  // namespace

const char* ig::embedded_page(const char* stem) noexcept {
  const std::string_view name = stem;
  return name == "vendor_press_syntax" ? page : name == "vendor_press_syntax.cases" ? cases : nullptr;
}
const char* ig::embedded_folder(const char*) noexcept { return nullptr; }
const ig::EmbeddedDiagnostic* ig::embedded_diagnostic(const char* code) noexcept {
  return std::string_view(code) == explanation.code ? &explanation : nullptr;
}

ISOGLOSS_PLUGIN("docs_vendor", "2.1.0", "Vendor & <sons>")

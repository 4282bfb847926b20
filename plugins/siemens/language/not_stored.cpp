// Why an assignment to a variable is not executed.
#include "language/expression_operators.hpp"
#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

void Environment::report_not_stored(ig::Block& b, const ig::Where& where, const std::string& name, const Value& value,
                                    Stored outcome) const {
  const std::string base = name.substr(0, name.find('['));
  const Variable* variable = store().find(name);
  if (variable == nullptr) variable = store().find(base);
  const std::string_view shown = name;
  switch (outcome) {
    case Stored::yes: return;
    case Stored::unknown: return report_name(b, ig::diag("SIE-0124"), where, name);
    case Stored::too_many: return b.report(ig::diag("SIE-0114"), where, shown);
    case Stored::wrong_type: return b.report(ig::diag("SIE-0130"), where, shown);
    case Stored::outside_array:
      return b.report(ig::diag("SIE-0304"), where, shown, std::string_view(variable->shown_as(base)));
    case Stored::out_of_range:
      return b.report(ig::diag("SIE-0360"), where, shown, std::string_view(text_of(value)),
                      std::string_view(variable->declared.range()));
    case Stored::too_long:
      return b.report(ig::diag("SIE-0361"), where, shown, std::string_view(value.text),
                      static_cast<double>(variable->declared.length));
  }
}

}  // namespace siemens

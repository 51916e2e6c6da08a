#pragma once

namespace taut::app {

// assets/report, embedded when the program is built.

/// The HTML page of the report with its style. <!--machine-->, <!--claims-->,
/// <!--promises-->, <!--figures--> and <!--methods--> are replaced.
extern const char* const report_page;
/// The text below figure 8 as HTML. <!--rows--> is replaced by those of its table.
extern const char* const methods_text;
/// The texts of the claims as TOML. {names} are replaced by the numbers of the rules.
extern const char* const claim_texts;

}  // namespace taut::app

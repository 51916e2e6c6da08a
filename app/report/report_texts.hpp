#pragma once

namespace taut::app {

// assets/report, embedded when the program is built.

/// The report's page with its style; <!--machine-->, <!--claims--> and <!--figures--> stand for what is
/// measured.
extern const char* const report_page;
/// The texts of the claims, TOML; {names} stand for the numbers of the rules.
extern const char* const claim_texts;

}  // namespace taut::app

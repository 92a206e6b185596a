//! Parts of the protocol that the adapter supports.

use crate::protocol::{Capabilities, ExceptionBreakpointsFilter};

/// Filter for all run-time errors.
pub(crate) const ALL_ERRORS: &str = "all";
/// Filter for run-time errors that no task handles.
pub(crate) const UNHANDLED_ERRORS: &str = "unhandled";
/// Filter for the run-time errors of motion.
pub(crate) const MOTION_ERRORS: &str = "motion";
/// Filter for contacts with things around the arm.
pub(crate) const CONTACTS: &str = "contacts";
/// Filter for run-time errors with given numbers.
pub(crate) const LISTED_ERRORS: &str = "codes";

/// Filter for failed assertions of tests.
pub(crate) const ASSERTIONS: &str = "assertion";

/// Returns the response to `initialize`.
pub(crate) fn capabilities() -> Capabilities {
    let yes = Some(true);
    Capabilities {
        supports_ansi_styling: yes,
        completion_trigger_characters: Some([".", ":"].map(str::to_owned).to_vec()),
        exception_breakpoint_filters: Some(filters()),
        supports_breakpoint_locations_request: yes,
        supports_cancel_request: yes,
        supports_clipboard_context: yes,
        supports_completions_request: yes,
        supports_conditional_breakpoints: yes,
        supports_configuration_done_request: yes,
        supports_data_breakpoints: yes,
        supports_delayed_stack_trace_loading: yes,
        supports_evaluate_for_hovers: yes,
        supports_exception_filter_options: yes,
        supports_exception_info_request: yes,
        supports_function_breakpoints: yes,
        supports_goto_targets_request: yes,
        supports_hit_conditional_breakpoints: yes,
        supports_loaded_sources_request: yes,
        supports_log_points: yes,
        supports_modules_request: yes,
        supports_restart_frame: yes,
        supports_restart_request: yes,
        supports_set_expression: yes,
        supports_set_variable: yes,
        supports_single_thread_execution_requests: yes,
        supports_step_back: yes,
        supports_step_in_targets_request: yes,
        supports_stepping_granularity: yes,
        supports_terminate_request: yes,
        supports_terminate_threads_request: yes,
        supports_value_formatting_options: yes,
        ..Capabilities::default()
    }
}

/// Returns the capabilities that differ after `attach`: the run continues after its client, and the client cannot
/// restart it.
pub(crate) fn of_attached_runs() -> Capabilities {
    let yes = Some(true);
    Capabilities {
        support_suspend_debuggee: yes,
        support_terminate_debuggee: yes,
        supports_restart_request: Some(false),
        ..Capabilities::default()
    }
}

/// Returns the exception filters.
pub(crate) fn filters() -> Vec<ExceptionBreakpointsFilter> {
    vec![
        filter(ALL_ERRORS, "All run-time errors", "Stop at each run-time error"),
        ExceptionBreakpointsFilter {
            default: Some(true),
            ..filter(UNHANDLED_ERRORS, "Unhandled run-time errors", "Stop at run-time errors that no task handles")
        },
        ExceptionBreakpointsFilter {
            default: Some(true),
            ..filter(ASSERTIONS, "Failed assertions", "Stop at assertions of the library val3assert that fail")
        },
        filter(
            MOTION_ERRORS,
            "Motion errors",
            "Stop at run-time errors of move instructions, and when the arm rests before a path that it cannot follow",
        ),
        filter(CONTACTS, "Contacts", "Stop when the arm or something that it carries touches a thing of cell.toml"),
        ExceptionBreakpointsFilter {
            supports_condition: Some(true),
            condition_description: Some("Numbers of run-time errors, such as 20, 70".to_owned()),
            ..filter(LISTED_ERRORS, "Run-time errors with a number", "Stop at run-time errors with these numbers")
        },
    ]
}

fn filter(filter: &str, label: &str, description: &str) -> ExceptionBreakpointsFilter {
    ExceptionBreakpointsFilter {
        filter: filter.to_owned(),
        label: label.to_owned(),
        description: Some(description.to_owned()),
        ..ExceptionBreakpointsFilter::default()
    }
}

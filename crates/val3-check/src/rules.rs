//! The rules, one per file.
//!
//! A new rule is a file in `rules/`, its name in the list below, and, unless it is a lint, an arm that maps a fault
//! to it.

use val3_analysis::problem::ProblemKind;
use val3_syntax::error::{Expected, SyntaxErrorKind};

use crate::{diagnostic::Wording, rule::Rule};

/// Declares a module for each rule and lists the rules, in the order given.
macro_rules! rules {
    ($($module:ident,)*) => {
        $(pub(crate) mod $module;)*
        static ALL: &[&Rule] = &[$(&$module::RULE),*];
    };
}

rules! {
    // Syntax
    xml_structure,
    xml_text,
    xml_attribute,
    conflict_marker,
    encoding,
    nesting_too_deep,
    control_character,
    syntax,
    unclosed_bracket,
    unmatched_bracket,
    unterminated_string,
    unclosed_block,
    unmatched_block_end,
    missing_break,
    break_outside_switch,
    case_outside_switch,
    case_after_default,
    second_default,
    statement_before_case,
    double_unary,
    assignment_in_expression,
    comment_after_code,
    reserved_word,
    foreign_spelling,
    return_value,
    missing_begin_end,
    code_outside_body,
    for_syntax,
    // Names
    unknown_name,
    unknown_program,
    unknown_instruction,
    missing_add_on,
    unknown_library,
    unknown_type,
    unknown_field,
    duplicate_name,
    name_too_long,
    invalid_name,
    reserved_name,
    not_a_value,
    unused_data,
    unused_parameter,
    unused_local,
    data_never_read,
    unused_program,
    unused_library,
    unused_type,
    local_never_read,
    hidden_data,
    hidden_word,
    ambiguous_name,
    lost_parameter,
    // Types
    operator_type,
    assignment_type,
    argument_type,
    argument_count,
    variable_expected,
    container_mismatch,
    condition_type,
    index_missing,
    index_not_allowed,
    index_count,
    index_type,
    index_out_of_bounds,
    case_type,
    switch_type,
    literal_field_count,
    literal_field_type,
    literal_without_type,
    for_counter,
    for_bound,
    no_effect,
    no_value,
    wrong_arm,
    string_too_long,
    not_assignable,
    argument_out_of_range,
    argument_taken_otherwise,
    unknown_format,
    unknown_date_key,
    serial_parameter,
    division_by_zero,
    negative_motion_limit,
    move_id_equality,
    computed_equality,
    array_without_index,
    fixed_size,
    result_ignored,
    self_assignment,
    same_operands,
    outputs_too_few,
    seconds,
    binary_size,
    negative_motion_data,
    empty_key,
    percent_out_of_range,
    percent_out_of_range_data,
    write_to_input,
    title_too_long,
    escape_in_string,
    // Flow and tasks
    constant_condition,
    unreachable_code,
    loop_never_runs,
    for_never_ends,
    for_counter_changed,
    duplicate_case,
    repeated_condition,
    loop_never_waits,
    busy_wait,
    recursion,
    unset_local,
    dead_store,
    complexity,
    for_counter_reused,
    unlinked_io,
    contradiction,
    equal_branches,
    unchanging_loop,
    task_local_by_reference,
    overrun_not_global,
    task_pace,
    task_period,
    too_many_periods,
    task_name,
    latch_without_delay,
    mutex_not_shared,
    key_not_cleared,
    entry_parameters,
    empty_block,
    mutex_never_released,
    return_with_mutex,
    loop_beyond_array,
    lock_without_mutex,
    unknown_task,
    duplicate_task,
    computed_task_name,
    torn_data,
    task_still_running,
    // Motion
    no_reference,
    data_without_reference,
    blend_cancelled,
    compliant_after_blend,
    configuration_change,
    output_before_arrival,
    move_while_stopped,
    position_while_moving,
    built_in_changed,
    global_refers_to_local,
    point_out_of_reach,
    joint_out_of_range,
    impossible_move,
    move_not_awaited,
    excess_speed,
    excess_speed_data,
    discarded_move,
    degenerate_circle,
    tiny_blend,
    contact_at_position,
    contact_in_move,
    // Project and data
    file_missing,
    file_unreadable,
    duplicate_entry,
    wrong_root,
    missing_attribute,
    invalid_attribute,
    unexpected_element,
    program_name_mismatch,
    file_outside,
    invalid_value,
    unknown_value_attribute,
    key_out_of_range,
    duplicate_key,
    invalid_key,
    unknown_user_field,
    user_field_type,
    invalid_size,
    father_missing,
    father_kind,
    father_circle,
    father_in_library,
    father_index,
    io_link_unknown,
    io_link_kind,
    library_circle,
    unlisted_file,
    instruction_version,
    version_feature,
    missing_stop,
    unknown_attribute,
    missing_element,
    namespace,
    path_separator,
    data_too_large,
    other_version,
    other_version_data,
    other_version_project,
    file_without_project,
    archive_not_read,
    page_binding,
    modbus_table,
    // Library interfaces
    library_item_unknown,
    library_item_private,
    library_never_loaded,
    lib_load_path,
    implementation_missing,
    implementation_private,
    implementation_different,
    unresolved_path,
    // Style
    keyword_spelling,
    unused_suppression,
    unknown_suppression,
    data_prefix,
    variable_prefix,
    unlinked_data,
    missing_description,
    unfinished_mark,
    empty_program,
    long_line,
    many_parameters,
    foreign_characters,
    bare_key_code,
    bare_error_number,
    duplicate_constant,
}

/// Every rule, sorted by code.
pub fn all() -> &'static [&'static Rule] {
    ALL
}

/// Rules that compare positions, moves and speeds with the arm and its cell (`val3 check --motion`).
pub fn of_motion() -> [&'static Rule; 7] {
    [
        &point_out_of_reach::RULE,
        &joint_out_of_range::RULE,
        &impossible_move::RULE,
        &excess_speed::RULE,
        &excess_speed_data::RULE,
        &contact_at_position::RULE,
        &contact_in_move::RULE,
    ]
}

/// Finds a rule by code (`V0203`, in upper or lower case) or by name (`argument-type`).
pub fn find(code_or_name: &str) -> Option<&'static Rule> {
    all()
        .iter()
        .copied()
        .find(|rule| rule.code.eq_ignore_ascii_case(code_or_name) || rule.name.eq_ignore_ascii_case(code_or_name))
}

/// A match over kinds of faults, one line per rule: `pattern => rule::function(fields);`.
macro_rules! words {
    ($kind:ident: $($pattern:pat => $rule:ident::$function:ident($($argument:expr),*);)*) => {
        match $kind {
            $($pattern => (&$rule::RULE, $rule::$function($($argument),*)),)*
        }
    };
}

/// Rule and wording of a syntax fault.
pub(crate) fn word_syntax(kind: &SyntaxErrorKind) -> (&'static Rule, Wording) {
    use SyntaxErrorKind as Kind;
    words! { kind:
        Kind::UnclosedElement { name } => xml_structure::unclosed(name);
        Kind::UnmatchedEndTag { name } => xml_structure::unmatched(name);
        Kind::Unterminated(part) => xml_structure::unterminated(*part);
        Kind::RootElement => xml_structure::root_element();
        Kind::UnexpectedText => xml_text::stray_text();
        Kind::UnknownEntity { text } => xml_text::unknown_entity(text);
        Kind::Doctype => xml_text::doctype();
        Kind::EarlySectionEnd => xml_text::early_section_end();
        Kind::MalformedAttribute { name } => xml_attribute::malformed(name);
        Kind::DuplicateAttribute { name } => xml_attribute::duplicate(name);
        Kind::ConflictMarker => conflict_marker::word();
        Kind::NestingTooDeep => nesting_too_deep::word();
        Kind::ControlCharacter { character } => control_character::word(*character);
        Kind::Expected { expected: Expected::ForAssign, found } => for_syntax::no_assignment(found);
        Kind::Expected { expected: Expected::ForTo, found } => for_syntax::no_to(found);
        Kind::Expected { expected: Expected::ForStep, found } => for_syntax::no_step(found);
        Kind::Expected { expected, found } => syntax::expected(*expected, found);
        Kind::TrailingText { found } => syntax::trailing(found);
        Kind::InvalidCharacter { character } => syntax::invalid_character(*character);
        Kind::UnclosedBracket { missing } => unclosed_bracket::word(*missing);
        Kind::UnmatchedBracket { bracket } => unmatched_bracket::word(*bracket);
        Kind::UnterminatedString => unterminated_string::word();
        Kind::NumberTooLarge => syntax::number_too_large();
        Kind::UnclosedBlock { block, missing } => unclosed_block::word(block, missing);
        Kind::DoWhile => unclosed_block::do_while();
        Kind::CrossedBlocks { inner, early, late } => unclosed_block::crossed(inner, early, late);
        Kind::UnmatchedBlockEnd { found, opener } => unmatched_block_end::word(found, opener);
        Kind::ElseAfterElse => unmatched_block_end::else_after_else();
        Kind::MissingBreak => missing_break::word();
        Kind::BreakOutsideSwitch => break_outside_switch::word();
        Kind::CaseOutsideSwitch => case_outside_switch::word();
        Kind::CaseAfterDefault => case_after_default::word();
        Kind::SecondDefault => second_default::word();
        Kind::StatementBeforeCase => statement_before_case::word();
        Kind::DoubleUnary => double_unary::word();
        Kind::AssignmentInExpression => assignment_in_expression::word();
        Kind::CommentAfterCode => comment_after_code::word();
        Kind::ReservedWord { word } => reserved_word::word(word);
        Kind::ForeignSpelling { found, instead } => foreign_spelling::word(found, instead);
        Kind::ReturnValue => return_value::word();
        Kind::MissingBegin => missing_begin_end::no_begin();
        Kind::MissingEnd => missing_begin_end::no_end();
        Kind::MissingBeginAndEnd => missing_begin_end::neither();
        Kind::NoCode => missing_begin_end::no_code();
        Kind::CodeOutsideBody => code_outside_body::word();
    }
}

/// Rule and wording of a fault that the analysis found.
pub(crate) fn word_problem(kind: &ProblemKind) -> (&'static Rule, Wording) {
    use ProblemKind as Kind;
    words! { kind:
        Kind::UnknownName { name, near } => unknown_name::word(name, near.as_deref());
        Kind::UnknownProgram { name, near, is } => unknown_program::word(name, near.as_deref(), *is);
        Kind::UnknownInstruction { name, near, is } => unknown_instruction::word(name, near.as_deref(), *is);
        Kind::MissingAddOn { name, add_on, lists_others, other_forms } =>
            missing_add_on::word(name, add_on.as_deref(), *lists_others, other_forms);
        Kind::UnknownLibrary { alias, near } => unknown_library::word(alias, near.as_deref());
        Kind::UnknownType { name, near } => unknown_type::word(name, near.as_deref());
        Kind::UnknownField { ty, field, near } => unknown_field::word(ty, field, near.as_deref());
        Kind::DuplicateName { name, what } => duplicate_name::word(name, *what);
        Kind::NameTooLong { name, limit } => name_too_long::word(name, *limit);
        Kind::InvalidName { name } => invalid_name::word(name);
        Kind::ReservedName { name } => reserved_name::word(name);
        Kind::NotAValue { name, is } => not_a_value::word(name, *is);
        Kind::OperatorType { op, left, right } => operator_type::word(op, left.as_deref(), right);
        Kind::AssignmentType { target, value } => assignment_type::word(target, value);
        Kind::NotAssignable => not_assignable::word();
        Kind::ArgumentType { callee, parameter, expected, found } =>
            argument_type::word(callee, parameter, expected, found);
        Kind::ArgumentCount { callee, expected, found, forms } =>
            argument_count::word(callee, expected, *found, forms);
        Kind::VariableExpected { callee, parameter } => variable_expected::word(callee, parameter);
        Kind::ContainerMismatch { callee, parameter, expected, found } =>
            container_mismatch::word(callee, parameter, expected, found);
        Kind::ConditionType { keyword, found } => condition_type::word(keyword, found);
        Kind::IndexMissing { name, ty } => index_missing::word(name, ty);
        Kind::IndexNotAllowed { name, ty, callee } => index_not_allowed::word(name, ty, callee.as_deref());
        Kind::IndexCount { name, expected, found } => index_count::word(name, *expected, *found);
        Kind::IndexType { name, expected, found } => index_type::word(name, expected, found);
        Kind::IndexOutOfBounds { name, index, size } => index_out_of_bounds::word(name, *index, *size);
        Kind::CaseType { expected, found } => case_type::word(expected, found);
        Kind::SwitchType { found } => switch_type::word(found);
        Kind::LiteralFieldCount { ty, expected, found } => literal_field_count::word(ty, *expected, *found);
        Kind::LiteralFieldType { ty, field, expected, found } =>
            literal_field_type::word(ty, field, expected, found);
        Kind::LiteralWithoutType { expected } => literal_without_type::word(expected.as_deref());
        Kind::ForCounter { found } => for_counter::word(found);
        Kind::ForBound { keyword, found } => for_bound::word(keyword, found);
        Kind::NoEffect => no_effect::word();
        Kind::NoValue { callee } => no_value::word(callee);
        Kind::WrongArm { found, expected } => wrong_arm::word(found, expected);
        Kind::StringTooLong(bytes) => string_too_long::word(*bytes);
        Kind::FileMissing { what, path } => file_missing::word(*what, path);
        Kind::FileOutside(what, path) => file_outside::word(*what, path);
        Kind::FileUnreadable { path, reason } => file_unreadable::word(path, reason);
        Kind::CellFileUnreadable(file) => file_unreadable::word_cell_file(file);
        Kind::ModbusTable(fault) => modbus_table::word(fault);
        Kind::Encoding(fault) => encoding::word(*fault);
        Kind::DuplicateEntry { what, name } => duplicate_entry::word(*what, name);
        Kind::WrongRoot { expected, found } => wrong_root::word(*expected, found);
        Kind::MissingAttribute { element, attribute, default, written } =>
            missing_attribute::word(element, attribute, default.as_deref(), written.as_deref());
        Kind::UnknownAttribute { element, attribute, near } =>
            unknown_attribute::word(element, attribute, near.as_deref());
        Kind::MissingElement { parent, element } => missing_element::word(parent, element);
        Kind::Namespace { element, found, expected } => namespace::word(element, found, expected);
        Kind::PathSeparator { path } => path_separator::word(path);
        Kind::UnresolvedPath { what, path, root, near } =>
            unresolved_path::word(*what, path, root, near.as_deref());
        Kind::InvalidAttribute { element, attribute, value, expected } =>
            invalid_attribute::word(element, attribute, value, expected);
        Kind::UnexpectedElement { name, parent } => unexpected_element::word(name, parent);
        Kind::ProgramNameMismatch { program, file } => program_name_mismatch::word(program, file);
        Kind::InvalidValue { ty, attribute, value, expected } =>
            invalid_value::word(ty, attribute, value, expected);
        Kind::UnknownValueAttribute { ty, attribute, near } =>
            unknown_value_attribute::word(ty, attribute, near.as_deref());
        Kind::KeyOutOfRange { key, size } => key_out_of_range::word(key, size);
        Kind::DuplicateKey { key } => duplicate_key::word(key);
        Kind::InvalidKey { key, dims } => invalid_key::word(key, *dims);
        Kind::UnknownUserField { ty, field, near } => unknown_user_field::word(ty, field, near.as_deref());
        Kind::UserFieldType { ty, field, expected, found } =>
            user_field_type::word(ty, field, expected, found);
        Kind::InvalidSize { size } => invalid_size::word(size);
        Kind::DataTooLarge(size) => data_too_large::word(size);
        Kind::FatherMissing { father, near } => father_missing::word(father, near.as_deref());
        Kind::FatherKind { father, expected, found } => father_kind::word(father, expected, found);
        Kind::FatherHidden { name, expected, found, uses } => father_kind::hidden(name, expected, found, *uses);
        Kind::FatherCircle { chain } => father_circle::word(chain);
        Kind::FatherInLibrary { father } => father_in_library::word(father);
        Kind::FatherIndex { father, size } => father_index::word(father, size);
        Kind::IoLinkUnknown { link, near } => io_link_unknown::word(link, near.as_deref());
        Kind::Page(fault) => page_binding::word(fault);
        Kind::IoLinkKind { link, expected, found } => io_link_kind::word(link, expected, found);
        Kind::LibraryCircle { chain } => library_circle::word(chain);
        Kind::LibraryItemUnknown { alias, item, what, near } =>
            library_item_unknown::word(alias, item, *what, near.as_deref());
        Kind::LibraryLeftOut { alias, missing, unlisted, uses } =>
            library_item_unknown::left_out(alias, missing, unlisted, *uses);
        Kind::LibraryItemPrivate { alias, item, what } => library_item_private::word(alias, item, *what);
        Kind::LibraryNeverLoaded { alias } => library_never_loaded::word(alias);
        Kind::LibLoadPath(path) => lib_load_path::word(path);
        Kind::ImplementationMissing { alias, library, items } => implementation_missing::word(alias, library, items);
        Kind::ImplementationPrivate { alias, library, item, what } =>
            implementation_private::word(alias, library, item, *what);
        Kind::ImplementationDifferent { alias, library, item, what, expected, found } =>
            implementation_different::word(alias, library, item, *what, expected, found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_ascend() {
        assert!(all().is_sorted_by(|a, b| a.code < b.code));
    }

    #[test]
    fn names_are_unique_and_found() {
        for rule in all() {
            assert_eq!(find(rule.name).map(|found| found.code), Some(rule.code));
            assert_eq!(find(&rule.code.to_lowercase()).map(|found| found.name), Some(rule.name));
        }
    }

    #[test]
    fn pages_say_what_why_and_how() {
        for rule in all() {
            for part in ["\n ## Why\n", "\n ## Bad\n", "\n ## Good\n"] {
                assert!(rule.page.contains(part), "{} lacks `{}`", rule.code, part.trim());
            }
        }
    }

    #[test]
    fn an_unknown_code_has_no_rule() {
        assert_eq!(find("V9999"), None);
    }
}

//! Code that is executed in the stack frame of a program.

use std::sync::Arc;

use val3_lang::memory::ValueType;

use crate::{ArgumentSite, LineMark, Op, Operand, Program};

/// An expression or statements that can use the parameters and locals of a program.
#[derive(Debug, Clone, PartialEq)]
pub struct Fragment {
    /// Code. Its variables are the variables of the other program, in the same order, all by reference.
    pub program: Arc<Program>,
    /// Value if the fragment is an expression; `None` for statements.
    pub value: Option<FragmentValue>,
}

/// An expression's value. It can be read while the code is at the last operation.
#[derive(Debug, Clone, PartialEq)]
pub struct FragmentValue {
    /// Operand with the value.
    pub site: ArgumentSite,
    /// Type.
    pub kind: Arc<ValueType>,
}

impl FragmentValue {
    /// Whether the value is computed into the fragment's frame. All variables are references to other places.
    #[must_use]
    pub fn is_result(&self) -> bool {
        matches!(self.site, ArgumentSite::Value(Operand::Frame(_), _))
    }
}

impl Fragment {
    /// Creates a fragment of statements. The task stops before each `return`, because the caller of the fragment is no
    /// program.
    #[must_use]
    pub fn statements(mut program: Program) -> Self {
        for step in program.code.iter_mut().filter(|step| step.op == Op::Return) {
            step.mark = if step.mark.begins_line() { LineMark::Stop } else { LineMark::StopWithin };
        }
        Self { program: Arc::new(program), value: None }
    }

    /// Creates a fragment for an expression. The task stops before the last operation, where the value can be read.
    #[must_use]
    pub fn expression(mut program: Program, value: FragmentValue) -> Self {
        if let Some(last) = program.code.last_mut().filter(|last| last.op == Op::Return) {
            last.mark = LineMark::Stop;
        }
        Self { program: Arc::new(program), value: Some(value) }
    }

    /// Returns the last operation.
    #[must_use]
    pub fn end(&self) -> u32 {
        u32::try_from(self.program.code.len()).unwrap_or(u32::MAX).saturating_sub(1)
    }
}

#[cfg(test)]
mod tests {
    use val3_lang::memory::Lanes;
    use val3_lang::types::BaseType;

    use super::*;
    use crate::{Image, assemble};

    fn program(code: &str) -> Program {
        let Image { mut programs, .. } = assemble(&format!("program p\nframe n2\n{code}\nend")).unwrap();
        programs.remove(0)
    }

    fn value(operand: Operand) -> FragmentValue {
        let kind = Arc::new(ValueType::builtin(BaseType::Num, None));
        FragmentValue { site: ArgumentSite::Value(operand, BaseType::Num), kind }
    }

    #[test]
    fn a_task_stops_where_the_value_of_an_expression_can_be_read() {
        let fragment = Fragment::expression(program("Add n0 n0 n1\nReturn"), value(Operand::Frame(Lanes::default())));
        assert_eq!(fragment.end(), 1);
        let marks: Vec<LineMark> = fragment.program.code.iter().map(|step| step.mark).collect();
        assert_eq!(marks, [LineMark::Within, LineMark::Stop]);
        let endless = Fragment::expression(program("on: Jump on"), value(Operand::Frame(Lanes::default())));
        assert_eq!(endless.program.code[0].mark, LineMark::Within);
    }

    #[test]
    fn statements_have_no_value_and_stop_before_each_return() {
        let fragment = Fragment::statements(program("line 1 Add n0 n0 n1\nline 2 Return\nReturn"));
        let marks: Vec<LineMark> = fragment.program.code.iter().map(|step| step.mark).collect();
        assert_eq!(marks, [LineMark::Line, LineMark::Stop, LineMark::StopWithin]);
        assert_eq!(fragment.value, None);
        assert_eq!(Fragment::statements(Program::default()).end(), 0);
    }

    #[test]
    fn only_a_value_of_the_own_frame_is_a_result() {
        assert!(value(Operand::Frame(Lanes::default())).is_result());
        assert!(!value(Operand::Place(0, Lanes::default())).is_result());
        let kind = Arc::new(ValueType::builtin(BaseType::Num, None));
        assert!(!FragmentValue { site: ArgumentSite::Library(0), kind }.is_result());
    }
}

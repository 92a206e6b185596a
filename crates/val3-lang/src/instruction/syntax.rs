//! Syntax lines in the manual's notation.

use std::fmt::{self, Display, Write};

use super::{ArgumentForm, InstructionParam, Overload};
use crate::{keywords, types::BaseType};

impl Overload {
    /// Syntax line of this form: `num movej(joint jPosition, tool tTool, mdesc mDesc)`.
    ///
    /// `name` is the instruction's name. A form of a library identifier is written `num library:libLoad(…)`, and
    /// `taskCreate`, which has no parentheses, as in a program.
    #[must_use]
    pub fn signature(&self, name: &str) -> String {
        let special = keywords::is_task_creation(name);
        let mut line = String::new();
        if !special {
            line.push_str(self.result.map_or("void", BaseType::name));
            line.push(' ');
        }
        if self.on_library {
            line.push_str("library:");
        }
        line.push_str(name);
        line.push_str(if special { " " } else { "(" });
        self.write_params(&mut line);
        if !special {
            line.push(')');
        }
        line
    }

    fn write_params(&self, line: &mut String) {
        for (position, param) in self.params.iter().enumerate() {
            if position > 0 {
                line.push_str(", ");
            }
            // Writing to a string cannot fail.
            let _ = write!(line, "{param}");
        }
    }
}

/// Formats a parameter as in a syntax line: `num& nData[]`, `T variable`, `program(...)`.
impl Display for InstructionParam {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.shape.write_param(f, self.ty, self.name)
    }
}

impl ArgumentForm {
    /// Whether the argument is passed by reference (2.6).
    #[must_use]
    pub fn is_by_reference(self) -> bool {
        matches!(self, Self::Reference | Self::Array { .. } | Self::Collection)
    }

    /// Writes a parameter of this form as in a syntax line; `None` means any type.
    pub(crate) fn write_param(self, f: &mut fmt::Formatter<'_>, ty: Option<BaseType>, name: &str) -> fmt::Result {
        if self == Self::ProgramCall {
            return write!(f, "{name}(...)");
        }
        let ty = ty.map_or("T", BaseType::name);
        let reference = if self.is_by_reference() { "&" } else { "" };
        write!(f, "{ty}{reference} {name}{}", self.brackets())
    }

    /// Brackets after the name in a syntax line.
    fn brackets(self) -> &'static str {
        match self {
            Self::Array { dims: 1 } => "[]",
            Self::Array { dims: 2 } => "[,]",
            Self::Array { .. } => "[,,]",
            Self::Collection => "[\"\"]",
            Self::Value | Self::Reference | Self::Whole | Self::Slot | Self::Item | Self::ProgramCall => "",
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::instructions::find;

    fn signatures(name: &str) -> Vec<String> {
        find(name).map(super::super::Instruction::signatures).unwrap_or_default()
    }

    #[test]
    fn reads_as_in_the_manual() {
        assert_eq!(signatures("movel"), ["num movel(point pPosition, tool tTool, mdesc mDesc)"]);
        assert_eq!(signatures("sioSet").first().map(String::as_str), Some("num sioSet(sio siOutput, num& nData[])"));
        assert_eq!(signatures("size"), ["num size(T variable)", "num size(T variable, num nDimension)"]);
        assert_eq!(signatures("taskCreate"), ["taskCreate string sName, num nPriority, program(...)"]);
        assert_eq!(signatures("libPath"), ["string library:libPath()", "string libPath()"]);
        assert_eq!(signatures("first"), ["string first(T& variable[\"\"])"]);
    }
}

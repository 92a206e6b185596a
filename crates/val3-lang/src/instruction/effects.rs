//! Instructions without side effects, which a debugger may call to show an expression.

use super::{ArgumentForm, CallClass, Instruction, InstructionParam, Overload};
use crate::types::BaseType;

/// Functions with side effects: each call of `$fileOpen` opens a file.
const ACTING: [&str; 1] = ["$fileOpen"];

impl Instruction {
    /// Whether a call of this form has side effects: it acts, waits, or writes to a variable.
    #[must_use]
    pub fn has_effects(&self, form: &Overload) -> bool {
        let writes = || form.params.iter().any(InstructionParam::is_written);
        form.class == CallClass::Modifier || self.blocking || ACTING.contains(&self.name) || writes()
    }
}

impl InstructionParam {
    /// Whether the instruction writes the parameter. Functions receive frames and tools by reference because of their
    /// fathers, and containers because they are passed completely.
    fn is_written(&self) -> bool {
        let is_scalar = matches!(self.ty, Some(BaseType::Num | BaseType::Bool | BaseType::String));
        self.shape == ArgumentForm::Reference && is_scalar
    }
}

#[cfg(test)]
mod tests {
    use crate::instructions;

    fn has_effects(name: &str) -> bool {
        let instruction = instructions::find(name).unwrap();
        let effects: Vec<bool> = instruction.overloads.iter().map(|form| instruction.has_effects(form)).collect();
        assert!(effects.iter().all(|effect| *effect == effects[0]), "{name}");
        effects[0]
    }

    #[test]
    fn functions_only_yield_a_value() {
        for name in ["sqrt", "len", "distance", "appro", "here", "herej", "taskStatus", "clock", "size", "isDefined"] {
            assert!(!has_effects(name), "{name}");
        }
    }

    #[test]
    fn instructions_that_act_wait_or_write_have_effects() {
        for name in ["movej", "delay", "wait", "watch", "toNum", "getKey", "sioGet", "link", "$fileOpen", "$getRot"] {
            assert!(has_effects(name), "{name}");
        }
    }
}

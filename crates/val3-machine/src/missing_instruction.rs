//! Message about a call that the virtual controller cannot execute.

use val3_lang::instructions;

/// Returns the message about a call of the instruction `name`, or about another part of a line with this name. The
/// supported forms are listed if only the arguments of the call are unsupported.
#[must_use]
pub fn missing_instruction(name: &str) -> String {
    let forms = instructions::find(name).map(|instruction| instruction.overloads).unwrap_or_default();
    let supported = forms.iter().filter(|form| form.run.is_some());
    let lines: Vec<String> = supported.map(|form| format!("`{}`", form.signature(name))).collect();
    if lines.is_empty() {
        return format!("this controller does not have `{name}`");
    }
    format!("this controller does not have `{name}` with these arguments, but {}", lines.join(" and "))
}

#[cfg(test)]
mod tests {
    use super::missing_instruction;

    #[test]
    fn a_known_instruction_has_other_arguments() {
        for unknown in ["$weld", "$setArmLimits", "Slot"] {
            assert_eq!(missing_instruction(unknown), format!("this controller does not have `{unknown}`"));
        }
        assert_eq!(
            missing_instruction("$fileOpen"),
            "this controller does not have `$fileOpen` with these arguments, but \
             `num $fileOpen(string sPath, string sMode)`"
        );
    }
}

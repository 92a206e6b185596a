//! Instructions that are missing in other versions of VAL 3, and their replacements.

/// Whether the instruction writes on the text page or reads its keys (4.3). A CS9 (s8) does not show this page.
#[must_use]
pub fn is_text_page(instruction: &str) -> bool {
    TEXT_PAGE.iter().any(|(name, _)| *name == instruction)
}

/// Replacement of an instruction that another version does not have.
#[must_use]
pub fn replacement(instruction: &str) -> Option<&'static str> {
    TEXT_PAGE.iter().chain(&OTHERS).find(|(name, _)| *name == instruction).map(|(_, replacement)| *replacement)
}

const TEXT_PAGE: [(&str, &str); 10] = [
    ("cls", "an HTML user page shows data that are bound to its elements: nothing has to be cleared"),
    ("gotoxy", "the layout is that of the HTML user page"),
    ("put", "bind a variable to an element of an HTML user page; `popUpMsg` and `logMsg` show single messages"),
    ("putln", "bind a variable to an element of an HTML user page; `popUpMsg` and `logMsg` show single messages"),
    ("title", "the title is that of the HTML user page"),
    ("setTextMode", "the style is that of the HTML user page"),
    ("getDisplayLen", "the layout is that of the HTML user page"),
    ("get", "`userPagePrompt` requests a value, or bind a variable to an input of an HTML user page"),
    ("getKey", "bind a program to a button of an HTML user page"),
    ("isKeyPressed", "bind a program to a button of an HTML user page"),
];

const OTHERS: [(&str, &str); 6] = [
    ("speedScale", "`setMonitorSpeed` sets the speed in per cent"),
    ("userPageSet", "`userPage` and `put` write on the text page"),
    ("userPagePrompt", "`get` edits a value on the text page"),
    ("userPageConfirm", "`popUpMsg` and `getKey`"),
    ("userPageAlert", "`popUpMsg` shows a message"),
    ("opcuaExport", "exchange the data by `sio` or a fieldbus"),
];

#[cfg(test)]
mod tests {
    use super::{OTHERS, TEXT_PAGE};
    use crate::instructions;

    #[test]
    fn all_are_instructions() {
        for (name, _) in TEXT_PAGE.iter().chain(&OTHERS) {
            assert!(instructions::find(name).is_some(), "{name}");
        }
    }
}

use crate::declare::instruction;

instruction! {
    /// Shows a message above the user pages.
    ///
    /// - `sText`: the message.
    ///
    /// On CS9 controllers. See `userPageConfirm` for a question.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    ///   userPageAlert("Tray is empty")
    /// ```
    "userPageAlert": Additions, since 8;
    modifier (string sText);
}

use crate::declare::instruction;

instruction! {
    /// Asks the operator for a text on the user page.
    ///
    /// - `sPrompt`: the question.
    /// - `sText`: gets the answer.
    /// - Result: `true` if there is an answer.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    /// string sOrder
    ///   if userPagePrompt("Order number",sOrder)
    ///     logMsg("order "+sOrder)
    ///   endIf
    /// ```
    "userPagePrompt": Additions, since 8;
    modifier (string sPrompt, string& sText) -> bool;
}

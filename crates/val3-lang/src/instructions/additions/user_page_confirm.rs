use crate::declare::instruction;

instruction! {
    /// Asks the operator a question on the user page.
    ///
    /// - `sText`: the question.
    /// - Result: `true` if the operator says yes.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    ///   if userPageConfirm("Empty the gripper?")
    ///     putln("emptying")
    ///   endIf
    /// ```
    "userPageConfirm": Additions, since 8;
    modifier (string sText) -> bool;
}

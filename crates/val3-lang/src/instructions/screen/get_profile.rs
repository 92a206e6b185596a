use crate::declare::instruction;

instruction! {
    /// Gives the name of the user profile that is active.
    ///
    /// - Result: the name.
    ///
    /// ## Example
    /// ```val3
    ///   putln("profile: "+getProfile())
    /// ```
    "getProfile": Screen "4.3";
    function () -> string;
}

use crate::declare::instruction;

instruction! {
    /// Clears a user page and puts its cursor into the upper left corner.
    ///
    /// - `scPage`: the page; without it, the default page.
    ///
    /// ## Example
    /// ```val3
    ///   cls()
    ///   putln("ready")
    /// ```
    "cls": Screen "4.3";
    modifier ();
    modifier (screen scPage);
}

use crate::declare::instruction;

instruction! {
    /// Sets the title of a user page.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `sText`: the title. The cursor stays where it is.
    ///
    /// ## Example
    /// ```val3
    ///   title("Palletiser")
    /// ```
    "title": Screen "4.3";
    modifier (string sText);
    modifier (screen scPage, string sText);
}

use crate::declare::instruction;

instruction! {
    /// Shows the user page on the pendant.
    ///
    /// - `scPage`: the page to show; without it, the default page.
    /// - `bFixed`: `true` keeps the operator on the user page (the user profile can still be changed), `false` sets
    ///   the other pages free again.
    /// - `sPage` (s8): the name of a page made with HTML, among those in the `interface` folder of the application.
    ///
    /// ## Example
    /// ```val3
    /// screen scMain
    ///   cls(scMain)
    ///   title(scMain,"Palletiser")
    ///   userPage(scMain)
    /// ```
    "userPage": Screen "4.3";
    modifier ();
    modifier (screen scPage);
    modifier (bool bFixed);
    modifier (string sPage) -> num since 8;
}

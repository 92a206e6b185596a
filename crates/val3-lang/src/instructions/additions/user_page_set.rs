use crate::declare::instruction;

instruction! {
    /// Changes an element of a user page.
    ///
    /// - `sPage`: the page, as it is called on the controller.
    /// - `sId`: the id of the element in the page.
    /// - `sAttribute`: the property that changes, such as `"innerHTML"` or `"style.backgroundColor"`.
    /// - `value`: its new value: a text or a number.
    ///
    /// On CS9 controllers user pages are HTML files of the application.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    /// num nDone
    ///   userPageSet("main","lblDone","innerHTML",toString("",nDone))
    /// ```
    "userPageSet": Additions, since 8;
    modifier (string sPage, string sId, string sAttribute, any value);
}

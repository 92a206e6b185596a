//! V0104: an instruction of an add-on that is not installed.

use smol_str::SmolStr;

use crate::{diagnostic::Wording, english::one_of, rule::rule};

rule! {
    /// An instruction belongs to an add-on that the cell does not have.
    ///
    /// ## Why
    /// Instructions whose names begin with `$` are not part of VAL 3: each belongs to an add-on of the controller. An
    /// installed add-on has a table of its instructions in the folder `usr/app` of the cell, one for each kind of arm.
    /// If the table is missing, the controller reports the instruction as an undefined function and does not load the
    /// application. If the cell has no such tables, as in most repositories, this is only information: make sure that
    /// the controller has the add-on. Each instruction is reported once per application. Without the table, arguments
    /// are compared with the forms that `val3 explain` shows. Other arguments are mentioned, because the add-on on the
    /// controller may accept them.
    ///
    /// ## Bad
    /// ```val3
    /// bool bThere
    ///
    /// bThere=$fileExists("Disk://log.txt")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// bool bThere
    ///
    /// bThere=$fileExists("Disk://log.txt")
    ///
    /// === /app/val3.Expansion.anthro.cfx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Language xmlns="http://www.staubli.com/robotics/VAL3/1">
    ///   <Version>s7.8</Version>
    ///   <Functions>
    ///     <Func>
    ///       <Name>$fileExists</Name>
    ///       <Return>bool</Return>
    ///       <Param index="0" type="string" dataRef="false" array="false" dictionary="false" arrayDim="0" />
    ///       <Lib>false</Lib>
    ///       <Class>Function</Class>
    ///     </Func>
    ///   </Functions>
    /// </Language>
    /// ```
    V0104 "missing-add-on" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, add_on: Option<&str>, cell_lists_others: bool, other_forms: &[SmolStr]) -> Wording {
    let (add_on, table) = match add_on {
        Some(add_on) => (format!("the add-on `{add_on}`"), format!("`val3.{add_on}.*.cfx`")),
        None => ("an add-on".to_owned(), "its table `val3.*.cfx`".to_owned()),
    };
    let (lack, help) = if cell_lists_others {
        let help = format!("install the add-on on the controller, and copy {table} into `usr/app` of the cell");
        (", which this cell does not have", help)
    } else {
        let help =
            format!("make sure that the controller has it; with {table} in `usr/app` of the cell this is checked");
        ("", help)
    };
    let need = format!("`{name}` needs {add_on}{lack}");
    if other_forms.is_empty() {
        return Wording::new(need, "instruction of an add-on", help);
    }
    Wording::new(
        format!("{need}, and is not known with these arguments"),
        "instruction of an add-on, with other arguments",
        format!("the known form is {}; `val3 run` ends at any other; {help}", one_of(other_forms)),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use val3_test::Fixture;

    use super::{RULE, word};
    use crate::rule::Severity;
    use crate::testing::check_files;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `$fileOpen` needs the add-on `Expansion`, which this cell does not have
            | instruction of an add-on
            ? install the add-on on the controller, and copy `val3.Expansion.*.cfx` into `usr/app` of the cell
        "#]]
        .assert_eq(&word("$fileOpen", Some("Expansion"), true, &[]).to_string());
        expect![[r#"
            `$myWeld` needs an add-on
            | instruction of an add-on
            ? make sure that the controller has it; with its table `val3.*.cfx` in `usr/app` of the cell this is checked
        "#]]
        .assert_eq(&word("$myWeld", None, false, &[]).to_string());
        expect![[r#"
            `$fileOpen` needs the add-on `Expansion`, and is not known with these arguments
            | instruction of an add-on, with other arguments
            ? the known form is `num $fileOpen(string sPath, string sMode)`; `val3 run` ends at any other; make sure that the controller has it; with `val3.Expansion.*.cfx` in `usr/app` of the cell this is checked
        "#]]
        .assert_eq(
            &word("$fileOpen", Some("Expansion"), false, &["num $fileOpen(string sPath, string sMode)".into()])
                .to_string(),
        );
    }

    /// Level of the finding in a cell with `table`, if any.
    fn level(table: &str) -> Option<Severity> {
        let fixture = Fixture::parse(&format!("$recClean(\"c\")\n{table}"));
        let files: Vec<_> = fixture.files.into_iter().map(|(path, text)| (path, text.into_bytes())).collect();
        check_files(&files).iter().find(|found| found.code == RULE.code).map(|found| found.severity)
    }

    #[test]
    fn the_level_depends_on_the_tables_of_the_cell() {
        let table = "=== /app/val3.Other.anthro.cfx\n<Language xmlns=\"http://www.staubli.com/robotics/VAL3/1\">\
                     <Version>s7.8</Version><Functions><Func><Name>$other</Name><Return>void</Return><Lib>false</Lib>\
                     <Class>Function</Class></Func></Functions></Language>";
        assert_eq!((level(""), level(table)), (Some(Severity::Info), Some(Severity::Error)));
    }
}

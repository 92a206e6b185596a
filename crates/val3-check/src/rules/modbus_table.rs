//! V0561: a fault of the tables of the cell's Modbus server.

use val3_analysis::problem::ModbusTableFault;

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// The tables of the Modbus server in `usr/applicom/Modbus/modbus.xml` contradict themselves, or do not determine the
    /// address or the link of an item.
    ///
    /// ## Why
    /// Programs use an item by its link, and a PLC uses it by its address. If two items have the same address, or `Offset`
    /// and `Syntaxe` differ, both sides exchange values of different items, without an error. If the link of an item is
    /// unknown, no link to the server can be compared with the tables (V0525). `val3 run --modbus` serves a file only if all
    /// addresses are certain.
    ///
    /// The finding is reported once, at the first project of the cell that is checked.
    ///
    /// ## Bad
    /// ```val3
    /// dio diStart
    ///
    /// === /applicom/Modbus/modbus.xml
    /// <TOPICSLIST>
    ///   <TOPIC Name="Modbus" Card="0" Channel="0" Equipment="0" Actif="1">
    ///     <MODULE IDModule="BOOLEAN" OutputSize="2">
    ///       <ITEM Name="bStart" Syntaxe="%Q0" Offset="0"/>
    ///       <ITEM Name="bReady" Syntaxe="%I1" Offset="2"/>
    ///     </MODULE>
    ///   </TOPIC>
    /// </TOPICSLIST>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// dio diStart
    ///
    /// === /applicom/Modbus/modbus.xml
    /// <TOPICSLIST>
    ///   <TOPIC Name="Modbus" Card="0" Channel="0" Equipment="0" Actif="1">
    ///     <MODULE IDModule="BOOLEAN" OutputSize="2">
    ///       <ITEM Name="bStart" Syntaxe="%Q0" Offset="0"/>
    ///       <ITEM Name="bReady" Syntaxe="%I1" Offset="1"/>
    ///     </MODULE>
    ///   </TOPIC>
    /// </TOPICSLIST>
    /// ```
    V0561 "modbus-table" Warning
}

/// Returns the wording of the finding about a line of the file.
pub(crate) fn word(fault: &ModbusTableFault) -> Wording {
    let help = if fault.hides_items {
        "correct the file, or copy it from the controller again: until then, links to the server are not checked"
    } else {
        "correct the file with the controller's tools, or copy it from the controller again"
    };
    let ModbusTableFault { path, line, description, .. } = fault;
    Wording::new(format!("line {line} of `usr/{path}`: {description}"), "project of this cell", help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::finished;

    fn worded(line: usize, description: &str, hides_items: bool) -> String {
        let path = "applicom/Modbus/modbus.xml".into();
        word(&ModbusTableFault { path, line, description: description.into(), hides_items }).to_string()
    }

    #[test]
    fn the_message_names_the_line_of_the_file() {
        expect![[r#"
            line 5 of `usr/applicom/Modbus/modbus.xml`: another item of this table is called `bStart`
            | project of this cell
            ? correct the file with the controller's tools, or copy it from the controller again
        "#]]
        .assert_eq(&worded(5, "another item of this table is called `bStart`", false));
    }

    #[test]
    fn the_help_names_the_links_that_are_not_checked() {
        expect![[r#"
            line 1 of `usr/applicom/Modbus/modbus.xml`: the file has no root element `TOPICSLIST`
            | project of this cell
            ? correct the file, or copy it from the controller again: until then, links to the server are not checked
        "#]]
        .assert_eq(&worded(1, "the file has no root element `TOPICSLIST`", true));
    }

    #[test]
    fn a_cell_with_several_applications_reports_a_fault_once() {
        let table = "=== /applicom/Modbus/modbus.xml\n<TOPICSLIST>\n<TOPIC Name=\"Modbus\" Card=\"0\" Channel=\"0\" \
                     Equipment=\"1\" Actif=\"1\"/>\n<TOPIC Name=\"Other\" Card=\"0\" Channel=\"2\" Equipment=\"0\" \
                     Actif=\"1\"/>\n</TOPICSLIST>\n";
        expect![[r#"
            main.pjx: line 2 of `usr/applicom/Modbus/modbus.xml`: `Equipment` is not 0, and it is unknown which links belong to such a topic (1 related)
            main.pjx: line 3 of `usr/applicom/Modbus/modbus.xml`: `Channel` is not 0, and it is unknown which links belong to such a topic (1 related)"#]].assert_eq(&finished(&format!("num nA\n--- one\nnum nA\n{table}"), "V0561").join("\n"));
    }
}

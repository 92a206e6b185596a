//! V0525: a link to an input or output that the cell does not have.

use crate::{diagnostic::Wording, phrase::did_you_mean_or, rule::rule};

rule! {
    /// Data is linked to an input, output or channel that the configuration of the cell does not have.
    ///
    /// ## Why
    /// `link` names an input, output, serial line or socket of the controller. If it does not exist, the data has no
    /// link, and the first instruction that uses it stops the task with run-time error 123. Compared are the files of boards,
    /// serial lines and sockets, the tables of the Modbus server (`applicom/Modbus/modbus.xml`), and the signals of a field bus,
    /// whose links are GUIDs (`hilscher/J207J208.xml`); without a device's file nothing is reported about its links. The configuration in the
    /// cell may be older than the one on the controller, so this is a warning.
    ///
    /// ## Bad
    /// ```val3
    /// siCamera="go"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="siCamera" access="private" xsi:type="array" type="sio" size="1">
    ///       <Value key="0" link="Socket\Camara" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// === /configs/sio.cfx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <sio>
    ///   <socketClt>
    ///     <String name="name" value="Camera" />
    ///     <Inet name="serverIp" value="192.168.0.10" />
    ///     <Uint name="portNumber" value="4000" />
    ///   </socketClt>
    /// </sio>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// siCamera="go"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="siCamera" access="private" xsi:type="array" type="sio" size="1">
    ///       <Value key="0" link="Socket\Camera" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// === /configs/sio.cfx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <sio>
    ///   <socketClt>
    ///     <String name="name" value="Camera" />
    ///     <Inet name="serverIp" value="192.168.0.10" />
    ///     <Uint name="portNumber" value="4000" />
    ///   </socketClt>
    /// </sio>
    /// ```
    V0525 "io-link-unknown" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(link: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("the cell has no input or output `{link}`"),
        "not in the configuration of the cell",
        did_you_mean_or(near, "add it to the configuration of the controller, or correct the link"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_proposes_a_similar_path() {
        expect![[r#"
            the cell has no input or output `Socket\Camara`
            | not in the configuration of the cell
            ? did you mean `Socket\Camera`?
        "#]]
        .assert_eq(&word(r"Socket\Camara", Some(r"Socket\Camera")).to_string());
    }

    #[test]
    fn the_help_is_empty_without_a_similar_path() {
        expect![[r#"
            the cell has no input or output `BasicIO-1\%I99`
            | not in the configuration of the cell
            ? add it to the configuration of the controller, or correct the link
        "#]]
        .assert_eq(&word(r"BasicIO-1\%I99", None).to_string());
    }
}

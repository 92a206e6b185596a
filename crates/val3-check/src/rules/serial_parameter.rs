//! V0229: an unknown parameter of a serial line, or an invalid value for one.

use val3_analysis::body::{Constant, ExprId};
use val3_lang::arguments::{SERIAL_PARAMETERS, SerialFault, SerialParameter, SerialValue};
use val3_lang::instructions::SIO_CTRL;
use val3_lang::suggest::nearest;

use crate::diagnostic::Wording;
use crate::english::{a, one_of};
use crate::lint::{Findings, ProgramView};
use crate::phrase::did_you_mean;
use crate::rule::rule;

rule! {
    /// A program changes an unknown parameter of a serial line or socket, or sets a parameter to an invalid value.
    ///
    /// ## Why
    /// `sioCtrl` raises no error. It returns -1 for an unknown parameter, -2 for a value of another type and -3 for a
    /// value that is not supported, and does not change the line (3.7.3).
    ///
    /// ## Bad
    /// ```val3
    /// sio siLine
    ///
    /// sioCtrl(siLine,"baudrates",9600)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// sio siLine
    ///
    /// sioCtrl(siLine,"baudRate",9600)
    /// ```
    V0229 "serial-parameter" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for call in program.calls_of(SIO_CTRL) {
        let [_, name, value] = *call.args else { continue };
        let Some(text) = program.body.string(name) else { continue };
        match SerialParameter::find(&text) {
            None => report_unknown(program, name, &text, found),
            Some(parameter) => check_value(program, parameter, value, found),
        }
    }
}

fn report_unknown(program: &ProgramView<'_>, id: ExprId, name: &str, found: &mut Findings) {
    let near = nearest(name, SERIAL_PARAMETERS.iter().map(|row| row.name));
    let reported = found.report(&RULE, program.range(id), unknown(name, near));
    if let Some(near) = near {
        let edit = program.write(program.range(id), &program.text(id).replace(name, near));
        reported.fix(format!("write `{near}`"), false, [edit]);
    }
}

fn check_value(program: &ProgramView<'_>, parameter: &SerialParameter, value: ExprId, found: &mut Findings) {
    let wanted = parameter.value.ty();
    let wording = match program.inference.ty(value).base.builtin() {
        Some(ty) if ty != wanted => other_type(parameter, ty.name()),
        Some(_) if !takes(parameter.value, program.body.constant(value)) => other_value(parameter, program.text(value)),
        _ => return,
    };
    found.report(&RULE, program.range(value), wording);
}

/// Whether the parameter accepts the value, or the value is unknown.
fn takes(value: SerialValue, constant: Option<Constant>) -> bool {
    match constant {
        Some(Constant::Number(number)) => value.takes_number(number),
        Some(Constant::String(text)) => value.takes_text(&text),
        Some(Constant::Bool(_)) | None => true,
    }
}

fn unknown(name: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("there is no parameter `{name}` of a serial line or socket"),
        returns(SerialFault::Unknown),
        did_you_mean(near),
    )
}

fn other_type(parameter: &SerialParameter, found: &str) -> Wording {
    let wanted = a(parameter.value.ty().name());
    Wording::new(
        format!("the parameter `{}` takes {wanted}, not {}", parameter.name, a(found)),
        returns(SerialFault::Type),
        "",
    )
}

fn other_value(parameter: &SerialParameter, found: &str) -> Wording {
    let values = match parameter.value {
        SerialValue::Between(low, high) => format!("{low} to {high}"),
        SerialValue::OneOf(texts) => one_of(texts),
        _ => a(parameter.value.ty().name()),
    };
    Wording::new(
        format!("the parameter `{}` takes {values}, not {found}", parameter.name),
        returns(SerialFault::Value),
        "",
    )
}

fn returns(fault: SerialFault) -> String {
    format!("nothing changes, the result is {}", fault.result())
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn unknown_parameters_and_values_are_reported() {
        expect![[r#"
            start.pgx:5 `"speed"` there is no parameter `speed` of a serial line or socket
              | nothing changes, the result is -1
            start.pgx:6 `"timeOuts"` there is no parameter `timeOuts` of a serial line or socket
              | nothing changes, the result is -1
              ? did you mean `timeout`?
              ! write `timeout` (unsafe)
            start.pgx:7 `0` the parameter `nagle` takes a `bool`, not a `num`
              | nothing changes, the result is -2
            start.pgx:8 `"80"` the parameter `port` takes a `num`, not a `string`
              | nothing changes, the result is -2
            start.pgx:9 `9` the parameter `bits` takes 5 to 8, not 9
              | nothing changes, the result is -3
            start.pgx:10 `"mark"` the parameter `parity` takes `none`, `even` or `odd`, not "mark"
              | nothing changes, the result is -3
        "#]]
        .assert_eq(&check(
            &RULE,
            "sio si\nsioCtrl(si,\"speed\",9600)\nsioCtrl(si,\"timeOuts\",1)\nsioCtrl(si,\"nagle\",0)\n\
             sioCtrl(si,\"port\",\"80\")\nsioCtrl(si,\"bits\",9)\nsioCtrl(si,\"parity\",\"mark\")",
        ));
    }

    #[test]
    fn known_parameters_and_values_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "sio si\nstring s\nnum n\nsioCtrl(si,\"bits\",8)\nsioCtrl(si,\"mode\",\"RS422\")\nsioCtrl(si,s,1)\n\
                 sioCtrl(si,\"timeout\",-1)\nsioCtrl(si,\"parity\",s)\nsioCtrl(si,\"stopBits\",n)\nsioCtrl(si,\"nagle\",false)"
            ),
            ""
        );
    }
}

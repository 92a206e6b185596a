//! Operations with their operands.

use val3_lang::number_functions::NumberFunction;

use super::ListingForm;
use super::error::Result;
use super::forms::Number;
use super::operands::{JumpOperand, Num, Place, View};
use super::reader::ListingReader;
use super::sites::{Calls, Copies, Instructions, Tasks};
use super::writer::Writer;
use crate::{ContainerRef, Op, TextOperand};

/// Reads and writes operations: the name, then the operands in their forms.
macro_rules! operations {
    ($($name:ident $($field:ident: $form:ty),*;)+) => {
        impl ListingForm for Op {
            type Value = Self;

            fn write(value: &Self, to: &mut Writer<'_>) {
                match value {
                    $(Self::$name { $($field),* } => {
                        to.put(stringify!($name));
                        $(to.put(" "); <$form>::write($field, to);)*
                    })+
                }
            }

            fn read(from: &mut ListingReader<'_>) -> Result<Self> {
                $(if from.accept(stringify!($name)) {
                    return Ok(Self::$name { $($field: <$form>::read(from)?),* });
                })+
                from.unexpected("an operation")
            }
        }
    };
}

operations! {
    Line;
    Jump to: JumpOperand;
    JumpUnless condition: Num, to: JumpOperand;
    JumpIf condition: Num, to: JumpOperand;
    IfLess a: Num, b: Num, to: JumpOperand;
    IfLessEqual a: Num, b: Num, to: JumpOperand;
    UnlessLess a: Num, b: Num, to: JumpOperand;
    UnlessLessEqual a: Num, b: Num, to: JumpOperand;
    UnlessEqual a: Num, b: Num, to: JumpOperand;
    IfEqual a: Num, b: Num, to: JumpOperand;
    Move to: Num, from: Num;
    Add to: Num, a: Num, b: Num;
    Subtract to: Num, a: Num, b: Num;
    Multiply to: Num, a: Num, b: Num;
    Divide to: Num, a: Num, b: Num;
    Remainder to: Num, a: Num, b: Num;
    Negate to: Num, a: Num;
    Not to: Num, a: Num;
    Less to: Num, a: Num, b: Num;
    LessEqual to: Num, a: Num, b: Num;
    Equal to: Num, a: Num, b: Num;
    NotEqual to: Num, a: Num, b: Num;
    Function function: NumberFunction, to: Num, a: Num, b: Num, c: Num;
    TextMove to: TextOperand, from: TextOperand;
    Concatenate to: TextOperand, a: TextOperand, b: TextOperand;
    TextEqual to: Num, a: TextOperand, b: TextOperand;
    IfTextEqual a: TextOperand, b: TextOperand, to: JumpOperand;
    UnlessTextEqual a: TextOperand, b: TextOperand, to: JumpOperand;
    LoadFirst to: Num, container: ContainerRef, lane: Number<u16>;
    StoreFirst container: ContainerRef, lane: Number<u16>, from: Num;
    LoadElement to: Num, container: ContainerRef, index: Num;
    StoreElement container: ContainerRef, index: Num, from: Num;
    LoadElement2 to: Num, container: ContainerRef, i: Num, j: Num;
    StoreElement2 container: ContainerRef, i: Num, j: Num, from: Num;
    LoadKey to: Num, container: ContainerRef, key: TextOperand;
    StoreKey container: ContainerRef, key: TextOperand, from: Num;
    FirstField to: View, container: ContainerRef, field: Number<u16>;
    ElementField to: View, container: ContainerRef, index: Num, field: Number<u16>;
    Field to: View, place: Place, field: Number<u16>;
    LocateFirst to: Place, container: ContainerRef;
    Locate to: Place, container: ContainerRef, index: Num;
    Locate2 to: Place, container: ContainerRef, i: Num, j: Num;
    Locate3 to: Place, container: ContainerRef, i: Num;
    LocateKey to: Place, container: ContainerRef, key: TextOperand;
    Load to: Num, place: Place, lane: Number<u16>;
    Store place: Place, lane: Number<u16>, from: Num;
    Copy site: Copies;
    Compare to: Num, site: Copies;
    Instruction site: Instructions;
    Call site: Calls;
    Return;
    CreateTask site: Tasks;
    WaitUntil condition: Num, retry: JumpOperand;
    Watch to: Num, condition: Num, seconds: Num, retry: JumpOperand;
    ForTest counter: Num, limit: Num, exit: JumpOperand;
    ForNext counter: Num, limit: Num, body: JumpOperand;
    ForNextUp counter: Num, limit: Num, body: JumpOperand;
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::{Image, assemble};

    /// Only their order distinguishes operands of the same form.
    #[test]
    fn operands_are_in_the_order_of_the_fields() {
        let text = "data nX num[9] program start frame n9/t9/p9/v9
            Subtract n1 n2 n3 Divide n1 n2 n3 Remainder n1 n2 n3 Move n1 n2 Negate n1 n2 Less n1 n2 n3
            LessEqual n1 n2 n3 UnlessLess n1 n2 end0 Function Limit n1 n2 n3 n4 TextMove t1 t2 Concatenate t1 t2 t3
            LoadFirst n1 $nX 2 StoreFirst $nX 2 n1 LoadElement n1 $nX n2 StoreElement $nX n2 n1
            LoadElement2 n1 $nX n2 n3 StoreElement2 $nX n2 n3 n1 LoadKey n1 $nX t2 StoreKey $nX t2 n1
            FirstField v1 $nX 2 ElementField v1 $nX n2 3 Field v1 p2 3 LocateFirst p1 $nX Locate p1 $nX n2
            Locate2 p1 $nX n2 n3 Locate3 p1 $nX n2 LocateKey p1 $nX t2 Load n1 p2 3 Store p2 3 n1
            Watch n1 n2 n3 end0 ForTest n1 n2 end0
            end0: Return end";
        let Image { programs, .. } = assemble(text).unwrap();
        let code: String = programs[0].code.iter().map(|step| format!("{:?}\n", step.op)).collect();
        expect![[r#"
            Subtract { to: 1, a: 2, b: 3 }
            Divide { to: 1, a: 2, b: 3 }
            Remainder { to: 1, a: 2, b: 3 }
            Move { to: 1, from: 2 }
            Negate { to: 1, a: 2 }
            Less { to: 1, a: 2, b: 3 }
            LessEqual { to: 1, a: 2, b: 3 }
            UnlessLess { a: 1, b: 2, to: 31 }
            Function { function: Limit, to: 1, a: 2, b: 3, c: 4 }
            TextMove { to: Register(1), from: Register(2) }
            Concatenate { to: Register(1), a: Register(2), b: Register(3) }
            LoadFirst { to: 1, container: Data(0), lane: 2 }
            StoreFirst { container: Data(0), lane: 2, from: 1 }
            LoadElement { to: 1, container: Data(0), index: 2 }
            StoreElement { container: Data(0), index: 2, from: 1 }
            LoadElement2 { to: 1, container: Data(0), i: 2, j: 3 }
            StoreElement2 { container: Data(0), i: 2, j: 3, from: 1 }
            LoadKey { to: 1, container: Data(0), key: Register(2) }
            StoreKey { container: Data(0), key: Register(2), from: 1 }
            FirstField { to: 1, container: Data(0), field: 2 }
            ElementField { to: 1, container: Data(0), index: 2, field: 3 }
            Field { to: 1, place: 2, field: 3 }
            LocateFirst { to: 1, container: Data(0) }
            Locate { to: 1, container: Data(0), index: 2 }
            Locate2 { to: 1, container: Data(0), i: 2, j: 3 }
            Locate3 { to: 1, container: Data(0), i: 2 }
            LocateKey { to: 1, container: Data(0), key: Register(2) }
            Load { to: 1, place: 2, lane: 3 }
            Store { place: 2, lane: 3, from: 1 }
            Watch { to: 1, condition: 2, seconds: 3, retry: 31 }
            ForTest { counter: 1, limit: 2, exit: 31 }
            Return
        "#]]
        .assert_eq(&code);
    }
}

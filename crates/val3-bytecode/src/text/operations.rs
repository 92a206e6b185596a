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

//! Images as text: [`disassemble`] writes it, [`assemble`] reads it back to an equal image.
//!
//! Tests of the run time are written in it, and it shows what the compiler has made of a program.
//!
//! ```
//! let text = r#"
//! image main "Disk://main/main.pjx"
//! data nSum num[1] {40}
//! data sNames string["a", "b"] {"x", _}      ; a collection; `b` has the default value
//!
//! program start
//!     frame n2/t1                            ; two numbers and a text
//!     nums n1=2
//! line 5                                     ; a line of the program begins, here at row 5 of its file
//!     LoadFirst n0 $nSum 0
//!     Add n0 n0 n1
//! line 6
//!     UnlessLess n0 n1 done
//!     TextMove t0 "never"
//! done:
//!     Instruction print (num n0)
//!     Return
//! end
//! "#;
//! let image = val3_bytecode::assemble(text)?;
//! assert_eq!(val3_bytecode::assemble(&val3_bytecode::disassemble(&image))?, image);
//!
//! let error = val3_bytecode::assemble("program start\n  Ad n0 n1 n2\nend").unwrap_err();
//! assert_eq!(error.to_string(), "2:3: `Ad` is found where an operation is expected");
//! # Ok::<(), val3_bytecode::AssemblyError>(())
//! ```
//!
//! Line breaks mean nothing. A comment begins with `;`. A name that is no identifier is quoted.
//!
//! | text | meaning |
//! |---|---|
//! | `n3`, `t0`, `l1` | a number, text or link of the frame; `n3/l1`: a value with both |
//! | `p2`, `p2+n6` | a place of the frame; lanes of a value there |
//! | `c0`, `v1` | a container of the frame; a container by reference |
//! | `$nSum`, `i0`, `world` | global data; an import by its number; built-in data |
//! | `"text"`, `#2` | a text constant; the same by its number |
//! | `num`, `joint arm Rs`, `@Slot` | a built-in type, with its arm; a user type |
//! | `num[3]`, `num["a"]` | a container with its sizes or keys |
//! | `num[]`, `num[,]`, `num[""]` | a parameter or local that is an array or a collection |
//! | `{1, (1 2 "x"), _}` | values at the start; `_` is the default |
//! | `line 5 counter 0`, `side 1` | a line or a side of a branch with its counter |
//! | `branch 5 "true" 0 "false" 1` | a branch with the counters of its sides |
//!
//! Each operation has the name and the operands of its [`Op`](crate::Op), with the entry of the table in place of its
//! number. Data, types and libraries are declared before their use. Programs call each other in any order.

mod counters;
mod error;
mod forms;
mod image;
mod operands;
mod operations;
mod program;
mod reader;
mod sites;
mod values;
mod writer;

use crate::{Image, Program};
use error::Result;
use reader::Reader;
use writer::Writer;

pub use error::AssemblyError;

/// A part of an image that the text spells in one way, in both directions.
trait Form {
    type Value;

    fn write(value: &Self::Value, to: &mut Writer<'_>);

    fn read(from: &mut Reader<'_>) -> Result<Self::Value>;
}

/// The image that a text describes. An example and the form of the text are in the [module](self).
///
/// # Errors
/// The first fault of the text.
pub fn assemble(text: &str) -> std::result::Result<Image, AssemblyError> {
    Reader::new(text)?.image()
}

/// The whole image as text.
#[must_use]
pub fn disassemble(image: &Image) -> String {
    let mut writer = Writer::new(image);
    writer.image();
    writer.text
}

/// One program of an image as text, without the types that it uses.
#[must_use]
pub fn disassemble_program(image: &Image, program: &Program) -> String {
    let mut writer = Writer::new(image);
    writer.program(program);
    writer.text
}

#[cfg(test)]
mod tests;

//! Text form of images: [`disassemble`] writes it, [`assemble`] reads it back to an equal image.
//!
//! Tests of the virtual machine are written in it, and it shows the compiler's output for a program.
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
//! Line breaks have no meaning. A comment begins with `;`. A name that is not an identifier is quoted.
//!
//! | text | meaning |
//! |---|---|
//! | `n3`, `t0`, `l1` | number, text or link of the frame; `n3/l1`: value with both |
//! | `p2`, `p2+n6` | place of the frame; lanes of a value at this place |
//! | `c0`, `v1` | container of the frame; container by reference |
//! | `$nSum`, `i0`, `world` | global data; import by number; built-in data |
//! | `"text"`, `#2` | string constant; string constant by number |
//! | `num`, `joint arm Rs`, `@Slot` | built-in type, optionally with an arm; user type |
//! | `num[3]`, `num["a"]` | container with sizes or keys |
//! | `num[]`, `num[,]`, `num[""]` | parameter or local that is an array or collection |
//! | `{1, (1 2 "x"), _}` | initial values; `_` is the default |
//! | `line 5 counter 0`, `side 1` | line or branch side with its counter |
//! | `closing 9` | keyword that closes a block, before the operation that executes it |
//! | `branch 5 "true" 0 "false" 1` | branch and its sides' counters |
//!
//! An operation is written as the name and the operands in its [`Op`](crate::Op). Instead of a table entry's number,
//! the text contains the entry. Data, types and libraries are declared before their use. Programs may call each other
//! in any order.

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
use reader::ListingReader;
use writer::Writer;

pub use error::AssemblyError;

/// Text form for a part of an image, in both directions.
trait ListingForm {
    type Value;

    fn write(value: &Self::Value, to: &mut Writer<'_>);

    fn read(from: &mut ListingReader<'_>) -> Result<Self::Value>;
}

/// Assembles an image. The [module](self) describes the text form, with an example.
///
/// # Errors
/// The first fault in the text.
pub fn assemble(text: &str) -> std::result::Result<Image, AssemblyError> {
    ListingReader::new(text)?.image()
}

/// Writes an entire image as text.
#[must_use]
pub fn disassemble(image: &Image) -> String {
    let mut writer = Writer::new(image);
    writer.image();
    writer.text
}

/// Writes one of an image's programs as text, without the types that it uses.
#[must_use]
pub fn disassemble_program(image: &Image, program: &Program) -> String {
    let mut writer = Writer::new(image);
    writer.program(program);
    writer.text
}

#[cfg(test)]
mod tests;

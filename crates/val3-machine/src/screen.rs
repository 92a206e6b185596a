//! Pendant for programs: user pages, keys and messages (chapter 4, 12.2).

mod ids;
mod keyboard;
mod line_editor;
mod page;
mod pendant;
mod reading;
mod row;
mod text_mode;
mod user_page;
mod width;

pub use ids::{PageId, ReadingId};
pub use keyboard::TAP;
pub use page::{COLUMNS, CursorCell, PageContent, ROWS};
pub use pendant::{HtmlCallback, HtmlPage, HtmlValue, Pendant, PopUp, ScreenEvent};
pub use row::ScreenCell;
pub use text_mode::TextMode;
pub use width::{display_columns, fitting};

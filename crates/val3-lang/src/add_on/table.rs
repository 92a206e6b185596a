//! Parses a table: `Language / Functions / Func { Name, Return, Param*, Lib, Class }`.

use quick_xml::{
    Error, Reader,
    errors::IllFormedError,
    events::{BytesStart, Event},
};

use super::{AddOnOverload, AddOnParam, AddOnTable, TableError, TableErrorKind, param::param};
use crate::{instruction::CallClass, types::BaseType};

/// Parses an add-on's table.
///
/// Unknown elements are ignored.
///
/// # Errors
/// The first error in the XML or in the content.
pub fn parse_table(xml: &str) -> Result<AddOnTable, TableError> {
    let mark = xml.len() - xml.trim_start_matches('\u{feff}').len();
    let body = xml.get(mark..).unwrap_or(xml);
    let mut reader = Reader::from_str(body);
    let mut parser = Parser::default();
    loop {
        let start = position(reader.buffer_position());
        let located = |kind| TableError { offset: mark + start, kind };
        match reader.read_event() {
            Ok(Event::Eof) => return parser.end().map_err(located),
            Ok(event) => parser.event(&event).map_err(located)?,
            Err(error) => {
                let offset = mark + position(reader.error_position());
                return Err(TableError { offset, kind: TableErrorKind::Xml(xml_fault(&error)) });
            }
        }
    }
}

fn xml_fault(error: &Error) -> String {
    match error {
        Error::Syntax(_) => "a tag, a comment or a declaration has no end".to_owned(),
        Error::IllFormed(IllFormedError::MismatchedEndTag { expected, found }) => {
            format!("`</{found}>` at the end of the element `{expected}`")
        }
        Error::IllFormed(IllFormedError::UnmatchedEndTag(name)) => format!("`</{name}>` without a start tag"),
        _ => "it is not well-formed".to_owned(),
    }
}

fn position(offset: u64) -> usize {
    usize::try_from(offset).unwrap_or(usize::MAX)
}

#[derive(Default)]
struct Parser {
    table: AddOnTable,
    is_table: bool,
    /// Number of open elements.
    depth: usize,
    /// Text of the innermost element so far.
    text: String,
    function: Option<FunctionDraft>,
}

/// A function whose end tag has not been read.
#[derive(Default)]
struct FunctionDraft {
    name: String,
    result: String,
    params: Vec<AddOnParam>,
    on_library: bool,
    modifies: bool,
}

type ParseResult = Result<(), TableErrorKind>;

impl Parser {
    fn event(&mut self, event: &Event<'_>) -> ParseResult {
        match event {
            Event::Start(element) => {
                self.open(element)?;
                self.depth += 1;
                Ok(())
            }
            Event::Empty(element) => self.open(element),
            Event::Text(text) => {
                self.text.push_str(text);
                Ok(())
            }
            Event::End(element) => {
                self.depth = self.depth.saturating_sub(1);
                self.close(element.local_name().as_ref())
            }
            _ => Ok(()),
        }
    }

    fn open(&mut self, element: &BytesStart<'_>) -> ParseResult {
        self.text.clear();
        let name = element.local_name();
        if !self.is_table && name.as_ref() != "Language" {
            return Err(TableErrorKind::NotATable);
        }
        self.is_table = true;
        if name.as_ref() == "Func" {
            self.function = Some(FunctionDraft::default());
        } else if let ("Param", Some(function)) = (name.as_ref(), &mut self.function) {
            function.params.push(param(element, function.params.len() + 1)?);
        }
        Ok(())
    }

    fn close(&mut self, name: &str) -> ParseResult {
        let text = std::mem::take(&mut self.text);
        let text = text.trim();
        if name == "Func" {
            return self.function.take().map_or(Ok(()), |draft| self.add(draft));
        }
        match (name, &mut self.function) {
            ("Name", Some(function)) => text.clone_into(&mut function.name),
            ("Return", Some(function)) => text.clone_into(&mut function.result),
            ("Lib", Some(function)) => function.on_library = text == "true",
            ("Class", Some(function)) => function.modifies = text == "Modifier",
            ("Version", None) => self.table.version = Some(text.to_owned()),
            _ => {}
        }
        Ok(())
    }

    fn add(&mut self, draft: FunctionDraft) -> ParseResult {
        if draft.name.is_empty() {
            return Err(TableErrorKind::NoName);
        }
        let overload = AddOnOverload {
            on_library: draft.on_library,
            params: draft.params,
            result: result(&draft.result)?,
            class: if draft.modifies { CallClass::Modifier } else { CallClass::Function },
        };
        self.table.add(draft.name, overload);
        Ok(())
    }

    fn end(self) -> Result<AddOnTable, TableErrorKind> {
        if self.depth > 0 {
            return Err(TableErrorKind::Xml("the file ends within an element".to_owned()));
        }
        if self.is_table { Ok(self.table) } else { Err(TableErrorKind::NotATable) }
    }
}

fn result(name: &str) -> Result<Option<BaseType>, TableErrorKind> {
    if matches!(name, "" | "void") {
        return Ok(None);
    }
    match BaseType::from_file_name(name) {
        Some((ty, _)) => Ok(Some(ty)),
        None => Err(TableErrorKind::UnknownResult(name.to_owned())),
    }
}

#[cfg(test)]
mod tests {
    use super::{AddOnTable, TableErrorKind, parse_table};
    use crate::instruction::{ArgumentForm, CallClass};

    const TABLE: &str = "\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\" ?>
<Language xmlns=\"http://www.staubli.com/robotics/VAL3/1\" >
  <Version>s7.8</Version>
  <Data></Data>
  <Functions>
    <Func>
      <Name>$follow</Name>
      <Return>num</Return>
      <Param index=\"0\" type=\"joint\" dataRef=\"false\" array=\"false\" arrayDim=\"0\" />
      <Param index=\"1\" type=\"num\" dataRef=\"true\" array=\"true\" arrayDim=\"2\" />
      <Param index=\"2\" type=\"*\" dataRef=\"true\"></Param>
      <Param index=\"3\" type=\"num\" collectionName=\"true\" />
      <Lib>false</Lib>
      <Class>Modifier</Class>
    </Func>
    <Func>
      <Name>$follow</Name>
      <Return>void</Return>
      <Lib>true</Lib>
      <Class>Function</Class>
    </Func>
  </Functions>
</Language>";

    fn kind(xml: &str) -> Option<TableErrorKind> {
        parse_table(xml).err().map(|error| error.kind)
    }

    fn with_function(body: &str) -> String {
        format!("<Language><Functions><Func>{body}</Func></Functions></Language>")
    }

    #[test]
    fn reads_functions_and_their_forms() {
        let table = parse_table(TABLE).unwrap_or_default();
        assert_eq!(table.version.as_deref(), Some("s7.8"));
        assert_eq!(table.instructions().len(), 1);
        let follow = table.find("$follow").cloned();
        let signatures = follow.as_ref().map(|follow| follow.signatures()).unwrap_or_default();
        assert_eq!(signatures, ["num $follow(joint j1, num& n2[,], T& x3, num n4)", "void library:$follow()"]);
        let classes: Vec<CallClass> =
            follow.iter().flat_map(|follow| &follow.overloads).map(|form| form.class).collect();
        assert_eq!(classes, [CallClass::Modifier, CallClass::Function]);
    }

    #[test]
    fn broken_tables_are_errors_with_a_position() {
        assert!(matches!(kind("<Language><Functions>"), Some(TableErrorKind::Xml(_))));
        for (xml, reason) in [
            ("<Language></Functions>", "`</Functions>` at the end of the element `Language`"),
            ("</Functions>", "`</Functions>` without a start tag"),
            ("<Language", "a tag, a comment or a declaration has no end"),
            ("<Language><!-- ", "a tag, a comment or a declaration has no end"),
        ] {
            assert_eq!(kind(xml), Some(TableErrorKind::Xml(reason.to_owned())), "{xml}");
        }
        assert_eq!(kind(""), Some(TableErrorKind::NotATable));
        assert_eq!(kind("<Project/>"), Some(TableErrorKind::NotATable));
        assert_eq!(kind(&with_function("<Return>num</Return>")), Some(TableErrorKind::NoName));
        let unknown = with_function("<Name>$x</Name><Return>matrix</Return>");
        assert_eq!(kind(&unknown), Some(TableErrorKind::UnknownResult("matrix".to_owned())));
        let deep = with_function("<Name>$x</Name><Param type=\"num\" array=\"true\" arrayDim=\"4\"/>");
        let error = parse_table(&deep).err();
        assert_eq!(error.as_ref().map(|error| error.offset), deep.find("<Param"));
        assert!(error.is_some_and(|error| error.to_string().contains("not `4`")));
    }

    #[test]
    fn an_array_of_no_dimension_is_any_container() {
        let param = "<Param type=\"num\" dataRef=\"true\" collectionName=\"true\" array=\"true\" arrayDim=\"0\"/>";
        let table = parse_table(&with_function(&format!("<Name>$x</Name><Return>bool</Return>{param}"))).unwrap();
        let shapes = table.find("$x").into_iter().flat_map(|found| &found.overloads).flat_map(|form| &form.params);
        assert_eq!(shapes.map(|param| param.shape).collect::<Vec<_>>(), [ArgumentForm::Whole]);
    }

    #[test]
    fn a_table_cut_anywhere_is_an_error_or_a_table() {
        for (end, _) in TABLE.char_indices() {
            let cut = parse_table(TABLE.get(..end).unwrap_or_default());
            assert!(cut.is_err_and(|error| error.offset <= TABLE.len()), "{end}");
        }
    }

    #[test]
    fn unknown_parts_are_skipped() {
        let table = parse_table("<Language><Later><Name>a</Name></Later></Language>");
        assert_eq!(table, Ok(AddOnTable::default()));
    }
}

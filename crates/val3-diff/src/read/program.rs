//! A program: its header and its code.

use smol_str::SmolStr;
use val3_analysis::items::program::{self, Header, ParamDecl};
use val3_analysis::xml::XmlElement;
use val3_lang::types::Container;
use val3_syntax::{Parse, SyntaxKind};

use super::code::{ProgramCode, line_ends};
use super::data::declaration;

/// A program of either dialect.
#[derive(Debug, Clone)]
pub(crate) struct ProgramVersion {
    pub(crate) header: Header,
    pub(crate) code: ProgramCode,
    pub(crate) description: String,
    /// Whether the code has syntax errors.
    pub(crate) has_errors: bool,
}

impl ProgramVersion {
    /// Reads the text of a `.pgx`; `None` if it is broken outside of the code.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let parse = val3_syntax::parse(text);
        let element = program::element(parse.view())?;
        let header = program::read(parse.view());
        let is_sound = !header.name.is_empty() && has_errors_in_code_alone(&parse);
        is_sound.then(|| Self {
            header,
            code: ProgramCode::read(parse.view()),
            description: description(element),
            has_errors: !parse.errors().is_empty(),
        })
    }

    /// Formats the signature: `pick(num x_nSlot, string& x_sName)`.
    pub(crate) fn signature(&self) -> String {
        format!("{}{}", self.header.name, self.parameters())
    }

    /// Formats the parameters: `(num x_nSlot, string& x_sName)`.
    pub(crate) fn parameters(&self) -> String {
        let params: Vec<String> = self.header.params.iter().map(parameter).collect();
        format!("({})", params.join(", "))
    }

    /// Formats the interface for callers: `pick(num, string&)`.
    pub(crate) fn interface(&self) -> String {
        let unnamed = self.header.params.iter().map(|param| ParamDecl { name: SmolStr::default(), ..param.clone() });
        let types: Vec<String> = unnamed.map(|param| parameter(&param).replace(' ', "")).collect();
        format!("{}({})", self.header.name, types.join(", "))
    }

    /// Returns `public` or `private`.
    pub(crate) fn access(&self) -> String {
        access(self.header.public)
    }

    /// Whether a parameter or a local variable has this name.
    pub(crate) fn has_local(&self, name: &str) -> bool {
        let params = self.header.params.iter().map(|param| &param.name);
        params.chain(self.header.locals.iter().map(|local| &local.name)).any(|known| known == name)
    }

    /// Returns the local variables: name and declaration.
    pub(crate) fn locals(&self) -> impl Iterator<Item = (&SmolStr, String)> {
        let locals = self.header.locals.iter();
        locals.map(|local| (&local.name, declaration(&local.type_name, &local.name, local.container, &local.sizes)))
    }
}

/// Returns `public` or `private`.
pub(crate) fn access(is_public: bool) -> String {
    if is_public { "public" } else { "private" }.to_owned()
}

fn parameter(param: &ParamDecl) -> String {
    let brackets = match param.container {
        Container::Element => "",
        // The old dialect does not distinguish an element by reference from an array.
        Container::Array { .. } if param.loose => "",
        Container::Array { dims: 0 | 1 } => "[]",
        Container::Array { dims: 2 } => "[,]",
        Container::Array { .. } => "[,,]",
        Container::Collection => "[\"\"]",
    };
    let reference = if param.by_reference { "&" } else { "" };
    let ty = if param.type_name.is_empty() { "?" } else { param.type_name.as_str() };
    format!("{ty}{reference} {}{brackets}", param.name)
}

fn has_errors_in_code_alone(parse: &Parse) -> bool {
    let code = program::code(parse.view()).map(|code| code.range());
    parse.errors().iter().all(|error| code.is_some_and(|code| code.contains_range(error.range)))
}

/// Returns the text of `<Description>`.
fn description(program: XmlElement<'_>) -> String {
    let Some(element) = program.child(&["Description", "description"]) else { return String::new() };
    line_ends(&text_in(element)).trim().to_owned()
}

/// Returns the decoded character data directly in an element.
pub(crate) fn text_in(element: XmlElement<'_>) -> String {
    let tokens = element.view().children_with_tokens().filter_map(rowan::NodeOrToken::into_token);
    let texts = tokens.filter(|token| matches!(token.kind(), SyntaxKind::XML_TEXT | SyntaxKind::ENTITY_REF));
    texts.map(|token| val3_syntax::decode_entities(token.text())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_dialects_are_read() {
        let new = ProgramVersion::read(
            "<Programs><Program name=\"pick\" access=\"public\"><Description><![CDATA[// a\r\n]]></Description><Parameters>\
             <Parameter name=\"x_n\" type=\"num\" xsi:type=\"element\"/><Parameter name=\"x_s\" type=\"string\" \
             xsi:type=\"array\" use=\"reference\" dimensions=\"2\"/></Parameters><Locals><Local name=\"l_i\" type=\"num\" \
             xsi:type=\"array\" size=\"3\"/></Locals><Code><![CDATA[begin\nend]]></Code></Program></Programs>",
        )
        .unwrap();
        assert_eq!(new.signature(), "pick(num x_n, string& x_s[,])");
        assert_eq!(new.interface(), "pick(num, string&[,])");
        assert_eq!((new.description.as_str(), new.access().as_str(), new.has_errors), ("// a", "public", false));
        assert_eq!(new.locals().map(|(_, local)| local).collect::<Vec<_>>(), ["num l_i[3]"]);
        let old = ProgramVersion::read(
            "<programList><program name=\"p\" public=\"true\"><paramSection><param name=\"x\" type=\"num\" byVal=\"false\"/>\
             </paramSection><source><code>begin\nx=\nend</code></source></program></programList>",
        )
        .unwrap();
        assert_eq!((old.signature().as_str(), old.has_errors), ("p(num& x)", true));
    }

    #[test]
    fn a_broken_file_is_no_program() {
        for text in ["", "text", "<Programs><Program name=\"p\"><Code>begin end</Code>", "<Database/>"] {
            assert!(ProgramVersion::read(text).is_none(), "{text}");
        }
    }
}

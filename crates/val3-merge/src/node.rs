//! Elements of a file with their identities.

use rowan::NodeOrToken;
use smol_str::SmolStr;
use val3_syntax::view::View;
use val3_syntax::xml::{self, Attribute, XmlElement};
use val3_syntax::{Parse, SyntaxKind, TextRange, TextSlice};

use crate::kind::{DECLARATION, MergedKind};

/// Maximum nesting of elements that are read, so that hostile files cannot overflow the stack.
const NESTING: usize = 64;

/// An element or a comment in a file. The node of the entire file also has the comments around the root as children.
#[derive(Debug)]
pub(crate) struct MergeNode<'t> {
    /// The element; `None` for a comment and for the file.
    pub(crate) element: Option<XmlElement<'t>>,
    /// Identity among siblings: name and key for an element, text for a comment.
    pub(crate) id: String,
    /// Attribute that contains the key.
    pub(crate) key_name: Option<&'static str>,
    /// Key of the element, for example a variable name or the index of a value.
    pub(crate) key: Option<SmolStr>,
    /// Range in the source.
    pub(crate) range: TextRange,
    /// Range between the tags; `None` for an empty element with one tag.
    pub(crate) content: Option<TextRange>,
    /// Child elements and comments.
    pub(crate) children: Vec<MergeNode<'t>>,
    /// Type of the contained values, in data files.
    pub(crate) type_name: SmolStr,
    /// Whether the element directly contains text other than blanks.
    pub(crate) has_text: bool,
    /// Text of the file.
    pub(crate) source: &'t str,
    /// Line end of the file.
    pub(crate) line_end: &'static str,
}

/// Parses a text for [`read`]. Comments with an unresolved conflict are plain comments in the tree.
pub(crate) fn parse(text: &str) -> Parse {
    let marker = crate::conflict::OPENING;
    let blank = format!("<!--{}", " ".repeat(marker.len() - 4));
    val3_syntax::parse(&text.replace(marker, &blank))
}

/// Reads the tree of a text; `None` if the text is no well-formed XML with one root element. Errors in the code are
/// allowed.
pub(crate) fn read<'t>(kind: MergedKind, parse: &'t Parse, source: &'t str) -> Option<MergeNode<'t>> {
    let root = xml::root(parse.view())?;
    let mut reader = NodeReader { kind, source, line_end: xml::line_end(source), codes: Vec::new() };
    let mut file = reader.node(parse.view().range());
    file.children = reader.children(parse.view(), [root].into_iter(), NodeLevel::default())?;
    file.content = Some(file.range);
    let mut errors = parse.errors().iter();
    errors.all(|error| reader.codes.iter().any(|code| code.contains_range(error.range))).then_some(file)
}

/// Depth of elements, and inherited properties.
#[derive(Clone, Default)]
struct NodeLevel {
    depth: usize,
    type_name: SmolStr,
}

struct NodeReader<'t> {
    kind: MergedKind,
    source: &'t str,
    line_end: &'static str,
    /// Ranges of code.
    codes: Vec<TextRange>,
}

impl<'t> NodeReader<'t> {
    /// Creates a node without an element.
    fn node(&self, range: TextRange) -> MergeNode<'t> {
        MergeNode {
            element: None,
            id: String::new(),
            key_name: None,
            key: None,
            range,
            content: None,
            children: Vec::new(),
            type_name: SmolStr::default(),
            has_text: false,
            source: self.source,
            line_end: self.line_end,
        }
    }

    /// Creates nodes for the elements and comments directly in `parent`; `None` if they are nested too deeply.
    fn children(
        &mut self,
        parent: View<'t>,
        elements: impl Iterator<Item = XmlElement<'t>>,
        level: NodeLevel,
    ) -> Option<Vec<MergeNode<'t>>> {
        if level.depth > NESTING {
            return None;
        }
        let mut nodes = Vec::new();
        let mut elements = elements.peekable();
        for child in parent.children_with_tokens() {
            match child {
                NodeOrToken::Token(token) if token.kind() == SyntaxKind::XML_COMMENT => {
                    let comment = self.node(token.range());
                    nodes.push(MergeNode { id: comment.text().to_owned(), ..comment });
                }
                NodeOrToken::Token(_) => {}
                NodeOrToken::Node(view) => {
                    if let Some(element) = elements.next_if(|element| element.view().range() == view.range()) {
                        nodes.push(self.element(element, level.clone())?);
                    }
                }
            }
        }
        Some(nodes)
    }

    fn element(&mut self, element: XmlElement<'t>, level: NodeLevel) -> Option<MergeNode<'t>> {
        let view = element.view();
        let mut node = self.node(view.range());
        if let Some((name, key)) = self.kind.key(element, level.depth) {
            (node.key_name, node.key) = (Some(name), Some(normal(&key).into()));
        }
        node.id = format!("{} {}", element.name(), node.key.as_deref().unwrap_or_default());
        node.element = Some(element);
        let end = view.child(SyntaxKind::END_TAG).map(|end| end.range().start());
        node.content = end.map(|end| TextRange::new(element.tag_range().end(), end));
        node.type_name = self.type_of(element, &level);
        node.has_text = view.child(SyntaxKind::CODE).is_some() || has_text(view);
        self.codes.extend(view.child(SyntaxKind::CODE).map(View::range));
        let inner = NodeLevel { depth: level.depth + 1, type_name: node.type_name.clone() };
        node.children = self.children(view, element.elements(), inner)?;
        Some(node)
    }

    /// Returns the type of the values in an element of a data file.
    fn type_of(&self, element: XmlElement<'t>, level: &NodeLevel) -> SmolStr {
        match element.name() {
            _ if self.kind != MergedKind::Data => SmolStr::default(),
            "Data" | "Field" => element.value("type").unwrap_or_default().into(),
            name if level.depth == DECLARATION => name.into(),
            _ => level.type_name.clone(),
        }
    }
}

/// Normalises a key, so that equal keys have equal texts: indexes without blanks, files in lower case.
fn normal(key: &str) -> String {
    let is_index = key.chars().all(|character| character.is_ascii_digit() || matches!(character, ',' | ' '));
    let is_file = [".pgx", ".dtx"].iter().any(|end| key.to_ascii_lowercase().ends_with(end));
    match (is_index, is_file) {
        (true, _) => key.replace(' ', ""),
        (_, true) => key.to_lowercase(),
        _ => key.to_owned(),
    }
}

fn has_text(view: View<'_>) -> bool {
    let mut tokens = view.children_with_tokens().filter_map(NodeOrToken::into_token);
    tokens.any(|token| match token.kind() {
        SyntaxKind::XML_TEXT | SyntaxKind::ENTITY_REF => !token.text().trim().is_empty(),
        SyntaxKind::CDATA_OPEN => true,
        _ => false,
    })
}

impl<'t> MergeNode<'t> {
    /// Returns the element name; empty for a comment and for the file.
    pub(crate) fn name(&self) -> &'t str {
        self.element.map_or("", XmlElement::name)
    }

    /// Returns an attribute's value.
    pub(crate) fn value(&self, name: &str) -> Option<String> {
        Some(self.element?.value(name)?.into_owned())
    }

    /// Returns an attribute.
    pub(crate) fn attribute(&self, name: &str) -> Option<Attribute<'t>> {
        self.element?.attribute(name)
    }

    /// Returns the text of the node.
    pub(crate) fn text(&self) -> &'t str {
        self.slice(self.range)
    }

    /// Returns the text of the content; empty for an element with one tag.
    pub(crate) fn content_text(&self) -> &'t str {
        self.content.map_or("", |content| self.slice(content))
    }

    /// Returns a part of the file's text.
    pub(crate) fn slice(&self, range: TextRange) -> &'t str {
        self.source.part(usize::from(range.start())..usize::from(range.end()))
    }
}

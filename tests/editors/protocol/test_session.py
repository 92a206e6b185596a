"""What a client gets from the server. Places are found by their text, so that the example may grow."""

from lsprotocol import types


class Program:
    """An open file of the cell."""

    def __init__(self, client, path):
        self.client, self.uri = client, path.as_uri()
        self.text = path.read_text(encoding="utf-8")
        self.version = 1
        document = types.TextDocumentItem(uri=self.uri, language_id="val3", version=1, text=self.text)
        client.text_document_did_open(types.DidOpenTextDocumentParams(text_document=document))

    @property
    def document(self):
        return types.TextDocumentIdentifier(uri=self.uri)

    def at(self, text):
        """The position of the only place with this text. Its line is plain ASCII, in every encoding alike."""
        before = self.text[: self.text.index(text)]
        return types.Position(line=before.count("\n"), character=len(before) - before.rfind("\n") - 1)

    def place(self, text):
        return {"text_document": self.document, "position": self.at(text)}

    def replace(self, old, new):
        """An incremental edit."""
        start = self.at(old)
        end = types.Position(line=start.line, character=start.character + len(old))
        change = types.TextDocumentContentChangePartial(range=types.Range(start=start, end=end), text=new)
        self.text = self.text.replace(old, new)
        self.version += 1
        version = types.VersionedTextDocumentIdentifier(uri=self.uri, version=self.version)
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(text_document=version, content_changes=[change]))


async def findings(client, program):
    """The findings of a program, asked for or sent, whichever the client is made for."""
    asked = client.capabilities.text_document.diagnostic is not None
    if asked:
        report = await client.text_document_diagnostic_async(types.DocumentDiagnosticParams(text_document=program.document))
        return report.items
    await client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    return client.diagnostics[program.uri]


async def test_a_mistake_is_found(client, cell):
    program = Program(client, cell / "pick.pgx")
    assert list(await findings(client, program)) == []
    program.replace("waitEndMove()", "waitEndMove(1)")
    (found,) = await findings(client, program)
    assert found.range.start.line == program.at("waitEndMove").line
    assert "waitEndMove" in found.message and str(found.code).startswith("V")


async def test_hover_tells_what_a_point_is(client, cell):
    program = Program(client, cell / "pick.pgx")
    hover = await client.text_document_hover_async(types.HoverParams(**program.place("pPick,tSuction")))
    assert "pPick" in str(hover.contents)


async def test_nothing_is_said_about_a_blank(client, cell):
    program = Program(client, cell / "pick.pgx")
    assert await client.text_document_hover_async(types.HoverParams(**program.place("  until"))) is None


async def test_definition_and_references(client, cell):
    program = Program(client, cell / "pick.pgx")
    place = program.place("tSuction,mSlow")
    definition = await client.text_document_definition_async(types.DefinitionParams(**place))
    first = definition[0] if isinstance(definition, (list, tuple)) else definition
    assert (getattr(first, "uri", None) or first.target_uri).endswith("palletiser.dtx")
    context = types.ReferenceContext(include_declaration=True)
    references = await client.text_document_references_async(types.ReferenceParams(context=context, **place))
    assert len({reference.uri for reference in references}) > 2


async def test_completion_and_its_resolution(client, cell):
    program = Program(client, cell / "pick.pgx")
    program.replace("waitEndMove()", "movej(pS)")
    position = program.at("pS)")
    position.character += len("pS")
    params = types.CompletionParams(text_document=program.document, position=position)
    result = await client.text_document_completion_async(params)
    items = result.items if isinstance(result, types.CompletionList) else result
    (safe,) = [item for item in items if item.label == "pSafe"]
    assert (await client.completion_item_resolve_async(safe)).label == "pSafe"


async def test_signature_help(client, cell):
    program = Program(client, cell / "pick.pgx")
    help = await client.text_document_signature_help_async(types.SignatureHelpParams(**program.place("tSuction,mFast")))
    assert any("movej" in signature.label for signature in help.signatures)
    assert help.active_parameter == 1 or help.signatures[help.active_signature or 0].active_parameter == 1


async def test_rename_touches_every_file(client, cell):
    program = Program(client, cell / "pick.pgx")
    place = program.place("bHolding=x_bOk")
    assert await client.text_document_prepare_rename_async(types.PrepareRenameParams(**place)) is not None
    edit = await client.text_document_rename_async(types.RenameParams(new_name="bCarries", **place))
    uris = set(edit.changes or {}) | {change.text_document.uri for change in edit.document_changes or []}
    names = {uri.rsplit("/", 1)[-1] for uri in uris}
    assert names == {"init.pgx", "pick.pgx", "place.pgx", "sensors.pgx", "palletiser.dtx"}


async def test_the_views_of_a_document(client, cell):
    program = Program(client, cell / "pick.pgx")
    document = program.document
    assert await client.text_document_document_symbol_async(types.DocumentSymbolParams(text_document=document))
    assert await client.text_document_folding_range_async(types.FoldingRangeParams(text_document=document))
    tokens = await client.text_document_semantic_tokens_full_async(types.SemanticTokensParams(text_document=document))
    assert len(tokens.data) % 5 == 0 and tokens.data
    highlights = await client.text_document_document_highlight_async(types.DocumentHighlightParams(**program.place("x_bOk=watch")))
    assert len(highlights) > 2
    position = program.at("pPick,tSuction")
    ranges = await client.text_document_selection_range_async(types.SelectionRangeParams(text_document=document, positions=[position]))
    assert len(ranges) == 1


async def test_formatting_leaves_a_formatted_file_alone(client, cell):
    program = Program(client, cell / "pick.pgx")
    options = types.FormattingOptions(tab_size=2, insert_spaces=True)
    params = types.DocumentFormattingParams(text_document=program.document, options=options)
    assert not await client.text_document_formatting_async(params)
    program.replace("waitEndMove()", "waitEndMove(  )")
    assert await client.text_document_formatting_async(params)


async def test_workspace_symbols(client, cell):
    Program(client, cell / "pick.pgx")
    symbols = await client.workspace_symbol_async(types.WorkspaceSymbolParams(query="clearPal"))
    assert [symbol.name for symbol in symbols] == ["clearPallet"]

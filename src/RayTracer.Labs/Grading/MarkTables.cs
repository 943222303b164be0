using System.Globalization;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Xml.Linq;

namespace RayTracer.Labs;

/// <summary>Tables of marks for other programs.</summary>
internal static class MarkTables
{
    private static readonly JsonSerializerOptions s_json = new() { WriteIndented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>Comma-separated values (RFC 4180), a row for each hand-in.</summary>
    public static string Csv(IReadOnlyList<Mark> marks) => string.Concat(marks.Select(m => new[]
    {
        m.Source, m.Check?.Card.Name ?? "", Number(m.Check?.Card.Lab), Number(m.Check?.Points), Number(m.Check?.Most),
        string.Join("; ", (m.Check?.Findings ?? []).Where(f => !f.IsRight).Select(f => f.Title)), m.Problem ?? "",
    }).Prepend(["hand-in", "name", "lab", "points", "most", "wrong", "note"]).Select(row => string.Join(',', row.Select(Cell)) + "\r\n"));

    /// <summary>JUnit XML: a suite for each hand-in, a test for each check.</summary>
    public static string JUnit(IReadOnlyList<Mark> marks) => new XDocument(new XElement("testsuites", marks.Select(m =>
    {
        IReadOnlyList<Finding> findings = m.Check is { Errors: [] } check ? check.Findings
            : [new Finding("it compiles", 0) { Sentence = m.Problem }];
        string name = m.Check is null ? m.Source : $"lab {m.Check.Card.Lab}: {m.Check.Card.Name}";
        return new XElement(
            "testsuite", Attribute("name", name), Attribute("tests", Number(findings.Count)), Attribute("failures", Number(findings.Count(f => !f.IsRight))),
            findings.Select(f => new XElement(
                "testcase", Attribute("classname", name), Attribute("name", f.Title),
                f.IsRight ? null : new XElement("failure", Attribute("message", f.Sentence ?? ""), Printable(Details(f))))));
    }))).ToString() + "\n";

    /// <summary>JSON: a list of hand-ins.</summary>
    public static string Json(IReadOnlyList<Mark> marks) => new JsonArray([.. marks.Select(m =>
    {
        JsonObject json = m.Check is null ? [] : Json(m.Check);
        json["handIn"] = m.Source;
        json["note"] = m.Note;
        return (JsonNode)json;
    })]).ToJsonString(s_json).ReplaceLineEndings("\n") + "\n";

    /// <summary>What came of one check of a folder.</summary>
    public static JsonObject Json(LabCheck check) => new()
    {
        ["lab"] = check.Card.Lab,
        ["name"] = check.Card.Name,
        ["points"] = check.Points,
        ["most"] = check.Most,
        ["errors"] = new JsonArray([.. check.Errors.Select(e => (JsonNode)e)]),
        ["checks"] = new JsonArray([.. check.Findings.Select(f => (JsonNode)new JsonObject
        {
            ["title"] = f.Title,
            ["points"] = f.Points,
            ["right"] = f.IsRight,
            ["recognised"] = f.IsRecognised,
            ["sentence"] = f.Sentence,
            ["case"] = f.Case,
            ["expected"] = f.Expected,
            ["found"] = f.Found,
        })]),
    };

    // Programs for tables take a cell that begins like this for a formula, which may do anything.
    private static string Cell(string text)
    {
        string harmless = text is ['=' or '+' or '-' or '@' or '\t' or '\r', ..] ? $"'{text}" : text;
        return harmless.IndexOfAny([',', '"', '\n', '\r']) < 0 ? harmless : $"\"{harmless.Replace("\"", "\"\"", StringComparison.Ordinal)}\"";
    }

    private static string Details(Finding finding)
    {
        (string Name, string? Text)[] lines = [("case", finding.Case), ("expected", finding.Expected), ("found", finding.Found)];
        return string.Join('\n', lines.Where(l => l.Text is not null).Select(l => $"{l.Name}: {l.Text}"));
    }

    private static XAttribute Attribute(string name, string text) => new(name, Printable(text));

    // XML knows no other control characters.
    private static string Printable(string text) => string.Concat(text.Select(c => char.IsControl(c) && c is not '\n' ? ' ' : char.IsSurrogate(c) ? '?' : c));

    private static string Number(int? number) => number?.ToString(CultureInfo.InvariantCulture) ?? "";
}

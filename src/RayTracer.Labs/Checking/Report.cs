using System.Net;
using System.Text;
using RayTracer.Imaging;

namespace RayTracer.Labs;

/// <summary>The page that shows a student what is right and wrong, with pictures.</summary>
internal static class Report
{
    // The folder, below that of the lab, for scenes of single cases.
    private const string Scenes = "report";

    /// <summary>Writes the page, and beside it the scenes of single cases.</summary>
    /// <param name="folder">The student's folder.</param>
    /// <param name="check">What came of it.</param>
    /// <returns>The page, and for each finding the commands that open its scenes in the Studio.</returns>
    public static (string Page, IReadOnlyList<IReadOnlyList<string>> Commands) Write(LabFolder folder, LabCheck check)
    {
        string title = $"{Lab.Of(check.Card.Lab).Title}: {check.Card.Name}";
        StringBuilder body = new();
        body.Append($"<h1>{Html(title)}</h1>\n<p>{check.Points} of {check.Most} points</p>\n");
        foreach (string error in check.Errors)
        {
            body.Append($"<pre class=\"wrong\">{Html(error)}</pre>\n");
        }

        List<IReadOnlyList<string>> commands = [];
        foreach ((Finding finding, int number) in check.Findings.Select((f, i) => (f, i + 1)))
        {
            string mark = finding.IsRight ? $"<span class=\"right\">✓ {finding.Points}" : "<span class=\"wrong\">✗ 0";
            body.Append($"<h2>{mark} of {finding.Points}</span> {Html(finding.Title)}</h2>\n");
            body.Append(Paragraph(finding.Sentence)).Append(Table(finding));
            List<string> own = [];
            foreach (Exhibit exhibit in finding.Exhibits ?? [])
            {
                string? scene = exhibit.Kind == "json" ? Scene(folder, number, exhibit) : null;
                body.Append(scene is null ? Picture(exhibit) : $"<p>{Html(exhibit.Title)}, in 3D: <code>{Html(scene)}</code></p>\n");
                own.AddRange(scene is null ? [] : [scene]);
            }

            commands.Add(own);
        }

        return (folder.Write("report.html", StandalonePage.Of(title, body.ToString())), commands);
    }

    private static string Paragraph(string? text) => text is null ? "" : $"<p>{Html(text)}</p>\n";

    private static string Table(Finding finding)
    {
        (string Name, string? Value)[] rows = [("in the smallest case", finding.Case), ("expected", finding.Expected), ("found", finding.Found)];
        string cells = string.Concat(rows.Where(r => r.Value is not null).Select(r => $"<tr><th>{r.Name}</th><td>{Html(r.Value!)}</td></tr>"));
        return cells.Length > 0 ? $"<table>{cells}</table>\n" : "";
    }

    // As a picture, scripts in an SVG do not run.
    private static string Picture(Exhibit exhibit)
    {
        string type = exhibit.Kind == "svg" ? "image/svg+xml" : "image/png";
        return $"<figure><img alt=\"{Html(exhibit.Title)}\" src=\"data:{type};base64,{Convert.ToBase64String(exhibit.Content)}\"><figcaption>{Html(exhibit.Title)}</figcaption></figure>\n";
    }

    private static string Scene(LabFolder folder, int number, Exhibit exhibit)
    {
        string name = Path.Combine(Scenes, $"check{number}.json");
        Directory.CreateDirectory(Path.Combine(folder.Path, Scenes));
        AtomicFile.Write(Path.Combine(folder.Path, name), stream => stream.Write(exhibit.Content));
        return $"raytracer studio {name.Replace('\\', '/')}";
    }

    private static string Html(string text) => WebUtility.HtmlEncode(text);
}

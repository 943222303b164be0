using System.Text;
using System.Xml.Linq;
using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Study;

/// <summary>The folder that a reproduction writes its pages and charts into.</summary>
/// <param name="folder">Its path; made if it is missing.</param>
/// <param name="output">Takes the names of pages that were written.</param>
internal sealed class OutputFolder(string folder, TextWriter output)
{
    private const string Markdown = "index.md";
    private const string Html = "index.html";

    /// <summary>The path of a file in the folder.</summary>
    public string this[string name] => Path.Combine(folder, name);

    /// <summary>Makes the folder, and finds out before the work whether pages and chart can be written.</summary>
    /// <param name="chart">The name of the chart's file.</param>
    /// <exception cref="JobException">The folder cannot be used.</exception>
    /// <exception cref="ImageWriteException">A file cannot be written.</exception>
    public void Prepare(string chart)
    {
        if (File.Exists(folder))
        {
            throw new JobException($"{folder} is a file, but a folder is expected");
        }

        try
        {
            Directory.CreateDirectory(folder);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new JobException($"the folder {folder} cannot be made: {e.Message.ReplaceLineEndings(" ").TrimEnd('.')}", e);
        }

        Array.ForEach([Markdown, Html, chart], name => AtomicFile.Check(this[name]));
    }

    /// <summary>Writes a chart.</summary>
    public void Write(string name, XDocument chart) => AtomicFile.Write(this[name], stream => chart.Save(stream));

    /// <summary>Writes a page in both formats.</summary>
    /// <param name="title">Its title.</param>
    /// <param name="content">Writes the rest.</param>
    public void WritePages(string title, Action<PageWriter> content)
    {
        WritePage(content, new MarkdownPage(title), Markdown);
        WritePage(content, new HtmlPage(title), Html);
    }

    private void WritePage(Action<PageWriter> content, PageWriter writer, string name)
    {
        content(writer);
        AtomicFile.Write(this[name], stream => stream.Write(Encoding.UTF8.GetBytes(writer.Finish())));
        output.WriteLine($"wrote {this[name]}");
    }
}

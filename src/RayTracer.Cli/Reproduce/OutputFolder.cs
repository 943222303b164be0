using System.Text;
using System.Xml.Linq;
using RayTracer.Imaging;

namespace RayTracer.Cli.Reproduce;

/// <summary>The folder that a reproduction writes its pages and charts into.</summary>
/// <param name="folder">Where; made if it is missing.</param>
/// <param name="streams">Where to say what was written.</param>
internal sealed class OutputFolder(string folder, Streams streams)
{
    private const string Markdown = "index.md";
    private const string Html = "index.html";

    /// <summary>The path of a file in the folder.</summary>
    public string this[string name] => Path.Combine(folder, name);

    /// <summary>Makes the folder, and finds out before the work whether pages and chart can be written.</summary>
    /// <param name="chart">The name of the chart's file.</param>
    /// <exception cref="CommandException">The folder cannot be used.</exception>
    /// <exception cref="ImageWriteException">A file cannot be written.</exception>
    public void Prepare(string chart)
    {
        if (File.Exists(folder))
        {
            throw new CommandException(ExitStatus.InputOutput, $"{folder} is a file, but a folder is expected");
        }

        try
        {
            Directory.CreateDirectory(folder);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new CommandException(ExitStatus.InputOutput, $"the folder {folder} cannot be made: {e.Message.ReplaceLineEndings(" ").TrimEnd('.')}");
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
        streams.Output.WriteLine($"wrote {this[name]}");
    }
}

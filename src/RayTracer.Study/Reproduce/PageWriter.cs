using System.Text;
using RayTracer.Jobs;

namespace RayTracer.Study;

/// <summary>Writes a page, part by part. All texts are plain: what has a meaning in the format is escaped.</summary>
internal abstract class PageWriter
{
    /// <summary>The text so far.</summary>
    private protected StringBuilder Content { get; } = new();

    /// <summary>Begins a section.</summary>
    public abstract void Heading(string text);

    /// <summary>Writes a paragraph.</summary>
    public abstract void Paragraph(string text);

    /// <summary>Writes a table; its first column is text, the others are numbers.</summary>
    /// <param name="header">The names of the columns.</param>
    /// <param name="rows">As many cells each.</param>
    public abstract void Table(IReadOnlyList<string> header, IEnumerable<IReadOnlyList<string>> rows);

    /// <summary>Writes a section about the machine that was measured on.</summary>
    public void Machine(Machine machine)
    {
        Heading("Machine");
        Table(["", "value"], machine.Rows.Select(r => (IReadOnlyList<string>)[r.Name, r.Value]));
    }

    /// <summary>Shows a picture.</summary>
    /// <param name="file">Its name, in the page's folder; plain letters, digits, points and hyphens.</param>
    /// <param name="caption">The caption.</param>
    public abstract void Picture(string file, string caption);

    /// <summary>The whole page.</summary>
    public abstract string Finish();
}

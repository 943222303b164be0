using System.Text;
using RayTracer.Description;

namespace RayTracer.Description;

/// <summary>The label of a source in the layers of light: that of the records around it, inner ones before outer ones.</summary>
/// <param name="Group">The light group; null where none is said.</param>
/// <param name="Name">The name, as it is written; null where there is none.</param>
internal sealed record LightGroupLabel(string? Group, string? Name)
{
    /// <summary>Names longer than this are cut off: OpenEXR's names have 255 bytes.</summary>
    private const int LongestName = 200;

    /// <summary>The resulting label: the group, or else the name; null where there is neither.</summary>
    public string? Text => Group ?? (Name is null ? null : Plain(Name));

    /// <summary>The label inside of a record.</summary>
    /// <param name="description">The record.</param>
    /// <param name="outer">The label around it.</param>
    public static LightGroupLabel? Of(ShapeDescription description, LightGroupLabel? outer)
    {
        (string? group, string? name) = (Plain(description.LightGroup), description.Name.Length > 0 ? description.Name : null);
        return Within(group is null && name is null ? null : new(group, name), outer);
    }

    /// <summary>A label that stands within another one.</summary>
    public static LightGroupLabel? Within(LightGroupLabel? inner, LightGroupLabel? outer) =>
        inner is null || outer is null ? inner ?? outer : new(inner.Group ?? outer.Group, inner.Name ?? outer.Name);

    /// <summary>
    /// The letters of a name that names of layers may have in all programs: ASCII letters and digits, - and _; others become _. Null for
    /// none.
    /// </summary>
    public static string? Plain(string text)
    {
        StringBuilder plain = new();
        foreach (char c in text.AsSpan(0, Math.Min(text.Length, LongestName)))
        {
            plain.Append(char.IsAsciiLetterOrDigit(c) || c is '-' or '_' ? c : '_');
        }

        return plain.Length > 0 ? plain.ToString() : null;
    }
}

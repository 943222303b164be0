using System.Windows.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A line of the outliner.</summary>
/// <param name="Pointer">What it is of.</param>
/// <param name="Name">What it is called.</param>
/// <param name="About">A word about it.</param>
/// <param name="Tip">A few words about it.</param>
/// <param name="Level">How deep it stands, from 0.</param>
/// <param name="Color">Its main colour as #rrggbb; empty where it has none.</param>
/// <param name="Icon">Its icon as SVG writes paths; empty where it has a colour.</param>
internal sealed record OutlineRow(string Pointer, string Name, string About, string Tip, int Level, string Color, string Icon)
{
    /// <summary>Whether it is the heading of a list.</summary>
    public bool IsHeading { get; init; }

    /// <summary>The tab of the properties that it belongs to; null for the selected thing's.</summary>
    public string? Tab { get; init; }

    /// <summary>Whether what it holds is shown; null where it holds nothing.</summary>
    public bool? IsOpen { get; init; }

    /// <summary>Shows or hides what it holds.</summary>
    public required ICommand Toggle { get; init; }

    /// <summary>Whether there is something to show or hide.</summary>
    public bool CanToggle => IsOpen is not null;

    /// <summary>Whether it has a colour.</summary>
    public bool HasColor => Color.Length > 0;

    /// <summary>How far it is moved to the right, in pixels.</summary>
    public double Indent => 14 * Level;

    /// <summary>The direction of the arrow before it.</summary>
    public string Twist => IsOpen == true ? "▾" : "▸";
}

using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A hit of a path of light, as a line of a table.</summary>
internal sealed class VertexRow(int number, InspectedVertex vertex, Action<string> select)
{
    /// <summary>Which of the path.</summary>
    public int Number => number;

    /// <summary>What happened.</summary>
    public string Event => SessionTexts.Of($"paths.events.{vertex.Event}");

    /// <summary>What that means.</summary>
    public string EventTip => SessionTexts.Keys("paths.eventsWhy").Contains(vertex.Event) ? SessionTexts.Of($"paths.eventsWhy.{vertex.Event}") : Event;

    /// <summary>What was hit, and its material.</summary>
    public string Thing => vertex.Material.Length > 0 ? $"{vertex.Name}, {vertex.Material}" : vertex.Name;

    /// <summary>The product of all weights before.</summary>
    public string Throughput => Figures.Color(vertex.Throughput);

    /// <summary>What the light is multiplied by here.</summary>
    public string Weight => Figures.Color(vertex.Weight);

    /// <summary>With what density the direction was chosen.</summary>
    public string Pdf => vertex.Pdf is { } pdf ? Figures.Short(pdf, 3) : SessionTexts.Of("paths.delta");

    /// <summary>Throughput times the light found here.</summary>
    public string Contribution => Figures.Color(vertex.Contribution);

    /// <summary>What that consists of.</summary>
    public string Parts => SessionTexts.Of("paths.parts", Figures.Color(vertex.Parts.Emitted), Figures.Color(vertex.Parts.Ambient), Figures.Color(vertex.Parts.Direct));

    /// <summary>Whether it can be selected.</summary>
    public bool CanSelect => vertex.Pointer is not null;

    /// <summary>Selects what was hit.</summary>
    public ICommand Select { get; } = new ActionCommand(() => select(vertex.Pointer ?? ""));
}

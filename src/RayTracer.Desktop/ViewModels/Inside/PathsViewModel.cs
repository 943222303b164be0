using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The light paths of one pixel: which samples there are, and the vertices of one as a table.</summary>
internal sealed class PathsViewModel : Observable
{
    private const int PerPage = 16;
    private readonly Hand _hand;
    private readonly Latest<(int X, int Y, int First)> _asking;
    private InspectedPixel? _pixel;
    private SampleRow? _chosen;
    private int _x;
    private int _y;
    private int _first;

    /// <summary>Paths of a session's picture.</summary>
    public PathsViewModel(Hand hand)
    {
        _hand = hand;
        _asking = new(Ask);
        Show = new ActionCommand(() => Inspect(_x, _y));
        More = new ActionCommand(() => Inspect(_x, _y, _first + PerPage));
        Fewer = new ActionCommand(() => Inspect(_x, _y, Math.Max(0, _first - PerPage)));
    }

    /// <summary>The pixel's column, as it is typed.</summary>
    public string X
    {
        get => Figures.Short(_x);
        set => Type(ref _x, value);
    }

    /// <summary>The pixel's row, as it is typed.</summary>
    public string Y
    {
        get => Figures.Short(_y);
        set => Type(ref _y, value);
    }

    /// <summary>Whether a pixel is chosen.</summary>
    public bool IsChosen => _pixel is not null;

    /// <summary>Whether none is.</summary>
    public bool IsNone => _pixel is null;

    /// <summary>The pixel in words.</summary>
    public string Title => _pixel is { } p ? SessionTexts.Of("paths.pixel", p.X, p.Y) : SessionTexts.Of("paths.none");

    /// <summary>The mean of all samples so far.</summary>
    public string Mean => _pixel?.Pixel is { } mean ? $"{SessionTexts.Of("paths.mean")}: {Figures.Color(mean)}" : "";

    /// <summary>The samples.</summary>
    public IReadOnlyList<SampleRow> Samples { get; private set; } = [];

    /// <summary>The chosen sample.</summary>
    public SampleRow? Chosen
    {
        get => _chosen;
        set
        {
            if (value is not null && Set(ref _chosen, value))
            {
                Tell(nameof(Vertices));
                Tell(nameof(Total));
            }
        }
    }

    /// <summary>The hits of the chosen sample's path.</summary>
    public IReadOnlyList<VertexRow> Vertices => [.. (_chosen?.Path.Vertices ?? []).Select((v, i) => new VertexRow(i, v, pointer => _hand.Do(s => s.Selection.Select(pointer))))];

    /// <summary>The radiance of the chosen sample.</summary>
    public string Total => _chosen?.Radiance ?? "";

    /// <summary>Looks into the pixel that is typed.</summary>
    public ICommand Show { get; }

    /// <summary>The next samples.</summary>
    public ICommand More { get; }

    /// <summary>The samples before.</summary>
    public ICommand Fewer { get; }

    /// <summary>Looks into a pixel.</summary>
    public void Inspect(int x, int y, int first = 0)
    {
        (_x, _y) = (x, y);
        _asking.Push((x, y, first));
    }

    private void Type(ref int place, string text)
    {
        if (Figures.Parse(text) is >= 0 and { } number)
        {
            place = (int)number;
        }

        Tell(nameof(X));
        Tell(nameof(Y));
    }

    private Task Ask((int X, int Y, int First) pixel) => _hand.Attempt(async () =>
    {
        _pixel = await _hand.Aside(s => s.Part<PathInspector>().Inspect(pixel.X, pixel.Y, pixel.First, PerPage));
        _first = pixel.First;
        Samples = [.. _pixel.Samples.Select(s => new SampleRow(s))];
        _chosen = Samples.Count > 0 ? Samples[0] : null;
        Tell("");
    });
}

/// <summary>A sample of the pixel that is looked into.</summary>
internal sealed record SampleRow(InspectedPath Path)
{
    /// <summary>Its number and radiance.</summary>
    public string Text => $"{SessionTexts.Of("paths.sample")} {Path.Sample}   {Radiance}";

    /// <summary>Its radiance in short.</summary>
    public string Radiance => Figures.Color(Path.Radiance);
}

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

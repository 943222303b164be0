using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The light paths of one pixel: which samples there are, and the vertices of one as a table.</summary>
internal sealed class PathsViewModel(SessionDispatcher dispatcher) : Observable
{
    private const int PerPage = 16;
    private InspectedPixel? _pixel;
    private SampleRow? _chosen;
    private int _x;
    private int _y;
    private int _first;

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

    public bool IsChosen => _pixel is not null;

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
            if (value is not null && SetProperty(ref _chosen, value))
            {
                Report(nameof(Vertices), nameof(Total), nameof(Ways), nameof(HasWays));
            }
        }
    }

    /// <summary>The hits of the chosen sample's path.</summary>
    public IReadOnlyList<VertexRow> Vertices => [.. (_chosen?.Path.Vertices ?? []).Select((v, i) => new VertexRow(i, v, pointer => dispatcher.Do(s => s.Selection.Select(pointer))))];

    /// <summary>Where light is traced too: how it came.</summary>
    public IReadOnlyList<WayRow> Ways => [.. (_chosen?.Path.Ways ?? []).Select(w => new WayRow(w))];

    public bool HasWays => _chosen?.Path.Ways.Count > 0;

    /// <summary>The radiance of the chosen sample.</summary>
    public string Total => _chosen?.Radiance ?? "";

    /// <summary>Looks into the pixel that is typed.</summary>
    public ICommand Show => field ??= new RelayCommand(() => Inspect(_x, _y));

    /// <summary>The next samples.</summary>
    public ICommand More => field ??= new RelayCommand(() => Inspect(_x, _y, Math.Min(_first + Samples.Count, (_pixel?.Total ?? 1) - 1)));

    /// <summary>The samples before.</summary>
    public ICommand Fewer => field ??= new RelayCommand(() => Inspect(_x, _y, Math.Max(0, _first - Samples.Count)));

    private Latest<(int X, int Y, int First)> Asking => field ??= new(Ask);

    /// <summary>Looks into a pixel.</summary>
    public void Inspect(int x, int y, int first = 0)
    {
        (_x, _y) = (x, y);
        Asking.Push((x, y, first));
    }

    private void Type(ref int place, string text)
    {
        if (Figures.Parse(text) is >= 0 and { } number)
        {
            place = (int)number;
        }

        Report(nameof(X), nameof(Y));
    }

    private Task Ask((int X, int Y, int First) pixel) => dispatcher.Attempt(async () =>
    {
        _pixel = await dispatcher.Aside(s => s.Part<PathInspector>().Inspect(pixel.X, pixel.Y, pixel.First, PerPage));
        _first = pixel.First;
        Samples = [.. _pixel.Samples.Select(s => new SampleRow(s))];
        _chosen = Samples.Count > 0 ? Samples[0] : null;
        OnPropertyChanged("");
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

/// <summary>A way in which light came, as a line of a table.</summary>
internal sealed record WayRow(InspectedWay Way)
{
    /// <summary>The vertices from the light and from the camera.</summary>
    public string Vertices => $"{Way.LightVertices} + {Way.CameraVertices}";

    public string Event => SessionTexts.Of($"paths.events.{Way.Event}");

    /// <summary>The meaning of the event.</summary>
    public string EventTip => SessionTexts.Of($"paths.eventsWhy.{Way.Event}");

    /// <summary>What the part from the light meets.</summary>
    public string Things => string.Join(" → ", Way.Things);

    /// <summary>What this way has of all that make the same path.</summary>
    public string Weight => Figures.Short(Way.Weight, 3);

    /// <summary>What it brings.</summary>
    public string Contribution => Figures.Color(Way.Radiance);
}

/// <summary>A hit of a path of light, as a line of a table.</summary>
internal sealed class VertexRow(int number, InspectedVertex vertex, Action<string> select)
{
    public int Number => number;

    public string Event => SessionTexts.Of($"paths.events.{vertex.Event}");

    /// <summary>The meaning of the event.</summary>
    public string EventTip =>
        SessionTexts.Keys("paths.eventsWhy").Contains(vertex.Event) ? SessionTexts.Of($"paths.eventsWhy.{vertex.Event}") : Event;

    /// <summary>The thing that was hit, and its material.</summary>
    public string Thing => vertex.Material.Length > 0 ? $"{vertex.Name}, {vertex.Material}" : vertex.Name;

    /// <summary>The product of all weights before.</summary>
    public string Throughput => Figures.Color(vertex.Throughput);

    /// <summary>The factor of the light at this vertex.</summary>
    public string Weight => Figures.Color(vertex.Weight);

    /// <summary>With what density the direction was chosen.</summary>
    public string Pdf => vertex.Pdf is { } pdf ? Figures.Short(pdf, 3) : SessionTexts.Of("paths.delta");

    /// <summary>Throughput times the light found here.</summary>
    public string Contribution => Figures.Color(vertex.Contribution);

    /// <summary>The parts of the contribution.</summary>
    public string Parts => SessionTexts.Of("paths.parts", Figures.Color(vertex.Parts.Emitted), Figures.Color(vertex.Parts.Ambient), Figures.Color(vertex.Parts.Direct));

    public bool CanSelect => vertex.Pointer is not null;

    /// <summary>Selects what was hit.</summary>
    public ICommand Select { get; } = new RelayCommand(() => select(vertex.Pointer ?? ""));
}

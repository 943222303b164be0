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

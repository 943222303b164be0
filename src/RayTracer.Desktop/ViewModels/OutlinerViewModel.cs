using System.Globalization;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The tree of all things.</summary>
/// <param name="choose">Takes the line that was chosen.</param>
internal sealed class OutlinerViewModel(Action<OutlineRow> choose) : Observable
{
    private static readonly Dictionary<string, string> Tabs = new(StringComparer.Ordinal)
    {
        ["camera"] = "camera",
        ["render"] = "render",
        ["background"] = "world",
        ["environment"] = "world",
        ["ambient"] = "world",
    };

    private static readonly Dictionary<string, string> Icons = new(StringComparer.Ordinal)
    {
        ["camera"] = "camera",
        ["render"] = "render",
        ["background"] = "background",
        ["environment"] = "background",
        ["ambient"] = "light",
        ["shapes"] = "sphere",
        ["lights"] = "light",
        ["materials"] = "material",
        ["textures"] = "texture",
        ["objects"] = "scene",
    };

    private readonly HashSet<string> _closed = new(StringComparer.Ordinal);
    private Outline? _outline;
    private string? _selection;
    private string? _section;
    private OutlineRow? _chosen;

    /// <summary>The lines that are shown, from top to bottom.</summary>
    public IReadOnlyList<OutlineRow> Rows { get; private set => SetProperty(ref field, value); } = [];

    /// <summary>Only things with this in their name or type are shown.</summary>
    public string Filter
    {
        get;
        set
        {
            if (SetProperty(ref field, value ?? ""))
            {
                Build();
            }
        }
    } = "";

    /// <summary>Returns whether the filter leaves nothing.</summary>
    public bool IsEmpty => Rows.Count == 0 && Filter.Length > 0;

    /// <summary>The chosen line.</summary>
    public OutlineRow? Chosen
    {
        get => _chosen;
        set
        {
            // A list that gets new lines has none chosen for a moment.
            if (value is null || value == _chosen)
            {
                return;
            }

            if (value.IsHeading)
            {
                OnPropertyChanged();
                return;
            }

            _section = value.Tab is null ? null : value.Pointer;
            SetProperty(ref _chosen, value);
            choose(value);
        }
    }

    /// <summary>Shows a document.</summary>
    public void Show(DocumentSnapshot shown)
    {
        (_outline, _selection) = (shown.Outline ?? _outline, shown.Selection);
        Build();
    }

    private void Build()
    {
        if (_outline is not { } outline)
        {
            return;
        }

        List<OutlineRow> rows = [];
        bool isSurrounded = outline.Environment.Summary != "none";
        foreach ((string kind, OutlineNode node) in Sections(outline).Where(s => Filter.Length == 0 && !(s.Kind == "background" && isSurrounded)))
        {
            rows.Add(Section(kind, node));
        }

        foreach ((string kind, IReadOnlyList<OutlineNode> nodes) in Groups(outline))
        {
            AddGroup(rows, kind, Filtered(nodes));
        }

        // Lines that are as they were stay, so that the view does not start from scratch.
        if (!rows.SequenceEqual(Rows, RowComparer.Instance))
        {
            Rows = rows;
        }

        string? pointer = _selection ?? _section;
        _chosen = Rows.FirstOrDefault(r => r.Pointer == pointer && !r.IsHeading);
        Report(nameof(Chosen), nameof(IsEmpty));
    }

    private static (string Kind, OutlineNode Node)[] Sections(Outline o) =>
        [("camera", o.Camera), ("render", o.Render), ("background", o.Background), ("environment", o.Environment), ("ambient", o.Ambient)];

    private static (string Kind, IReadOnlyList<OutlineNode> Nodes)[] Groups(Outline o) =>
        [("shapes", o.Shapes), ("lights", o.Lights), ("materials", o.Materials), ("textures", o.Textures), ("objects", o.Objects)];

    private OutlineRow Section(string kind, OutlineNode node) =>
        new(node.Pointer, SessionTexts.Of($"outliner.{kind}"), kind == "environment" ? node.Summary : "", node.Summary, 0, node.Color ?? "", IconOf(kind, node))
        {
            Tab = Tabs[kind],
            Toggle = Toggle(node.Pointer),
        };

    private void AddGroup(List<OutlineRow> rows, string kind, List<OutlineNode> nodes)
    {
        if (nodes.Count == 0 && (Filter.Length > 0 || kind == "objects"))
        {
            return;
        }

        string pointer = $"/{kind}";
        string count = nodes.Count == 0 ? SessionTexts.Of("outliner.empty") : nodes.Count.ToString(CultureInfo.InvariantCulture);
        bool isOpen = !_closed.Contains(pointer);
        rows.Add(new(pointer, SessionTexts.Of($"outliner.{kind}"), count, "", 0, "", "") { IsHeading = true, IsOpen = isOpen, Toggle = Toggle(pointer) });
        foreach (OutlineNode node in isOpen ? nodes : [])
        {
            Add(rows, kind, node, 1);
        }
    }

    private void Add(List<OutlineRow> rows, string kind, OutlineNode node, int level)
    {
        bool? isOpen = node.Children.Count == 0 ? null : !_closed.Contains(node.Pointer);
        string about = node.IsLight && kind != "lights" ? $"{SessionTexts.Of("outliner.shines")} · {node.Type}" : node.Type;
        rows.Add(new(node.Pointer, node.Name, about, node.Summary, level, node.Color ?? "", IconOf(kind, node)) { IsOpen = isOpen, Toggle = Toggle(node.Pointer) });
        foreach (OutlineNode child in isOpen == true ? node.Children : [])
        {
            Add(rows, kind, child, level + 1);
        }
    }

    private static string IconOf(string kind, OutlineNode node) => node.Color is null ? SessionCommand.IconOf(Icons[kind]) : "";

    private RelayCommand Toggle(string pointer) => new(() =>
    {
        if (!_closed.Remove(pointer))
        {
            _closed.Add(pointer);
        }

        Build();
    });

    private List<OutlineNode> Filtered(IReadOnlyList<OutlineNode> nodes)
    {
        string wanted = Filter.Trim();
        return wanted.Length == 0 ? [.. nodes] : [.. nodes.Select(n => n with { Children = Filtered(n.Children) })
            .Where(n => n.Children.Count > 0 || $"{n.Name} {n.Type}".Contains(wanted, StringComparison.OrdinalIgnoreCase))];
    }

    // What is to be seen of a line is what counts, not its command.
    private sealed class RowComparer : IEqualityComparer<OutlineRow>
    {
        public static RowComparer Instance { get; } = new();

        public bool Equals(OutlineRow? x, OutlineRow? y) => x is not null && y is not null && x with { Toggle = y.Toggle } == y;

        public int GetHashCode(OutlineRow row) => row.Pointer.GetHashCode(StringComparison.Ordinal);
    }
}

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
    public bool IsHeading { get; init; }

    /// <summary>The tab of the properties that it belongs to; null for the selected thing's.</summary>
    public string? Tab { get; init; }

    /// <summary>Returns whether its contents are shown; null where it has none.</summary>
    public bool? IsOpen { get; init; }

    /// <summary>Shows or hides what it holds.</summary>
    public required ICommand Toggle { get; init; }

    public bool CanToggle => IsOpen is not null;

    public bool HasColor => Color.Length > 0;

    /// <summary>The indentation in pixels.</summary>
    public double Indent => 14 * Level;

    /// <summary>The direction of the arrow before it.</summary>
    public string Twist => IsOpen == true ? "▾" : "▸";
}

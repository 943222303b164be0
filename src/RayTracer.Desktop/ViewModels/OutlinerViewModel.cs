using System.Globalization;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The tree of all things.</summary>
/// <param name="choose">Takes the line that was chosen.</param>
internal sealed class OutlinerViewModel(Action<OutlineRow> choose) : Observable
{
    private static readonly (string Kind, string Tab, string Icon, Func<Outline, OutlineNode> Node)[] Sections =
    [
        ("camera", "camera", "camera", o => o.Camera),
        ("render", "render", "render", o => o.Render),
        ("background", "world", "background", o => o.Background),
        ("environment", "world", "background", o => o.Environment),
        ("ambient", "world", "light", o => o.Ambient),
    ];

    private static readonly (string Kind, string Icon, Func<Outline, IReadOnlyList<OutlineNode>> Nodes)[] Groups =
    [
        ("shapes", "sphere", o => o.Shapes),
        ("lights", "light", o => o.Lights),
        ("materials", "material", o => o.Materials),
        ("textures", "texture", o => o.Textures),
        ("objects", "scene", o => o.Objects),
    ];

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
        foreach ((string kind, string tab, string icon, Func<Outline, OutlineNode> node) in Filter.Length == 0 ? Sections : [])
        {
            if (kind != "background" || !isSurrounded)
            {
                rows.Add(Section(kind, tab, icon, node(outline)));
            }
        }

        foreach ((string kind, string icon, Func<Outline, IReadOnlyList<OutlineNode>> nodes) in Groups)
        {
            AddGroup(rows, kind, icon, Filtered(nodes(outline)));
        }

        // Lines that are as they were stay, so that the view does not start from scratch.
        if (!rows.SequenceEqual(Rows))
        {
            Rows = rows;
        }

        string? pointer = _selection ?? _section;
        _chosen = Rows.FirstOrDefault(r => r.Pointer == pointer && !r.IsHeading);
        Report(nameof(Chosen), nameof(IsEmpty));
    }

    private OutlineRow Section(string kind, string tab, string icon, OutlineNode node) => new(
        node.Pointer, SessionTexts.Of($"outliner.{kind}"), kind == "environment" ? node.Summary : "", node.Summary, 0, node.Color ?? "", IconOf(icon, node))
    {
        Tab = tab,
        Toggle = Toggle,
    };

    private void AddGroup(List<OutlineRow> rows, string kind, string icon, List<OutlineNode> nodes)
    {
        if (nodes.Count == 0 && (Filter.Length > 0 || kind == "objects"))
        {
            return;
        }

        string pointer = $"/{kind}";
        string count = nodes.Count == 0 ? SessionTexts.Of("outliner.empty") : nodes.Count.ToString(CultureInfo.InvariantCulture);
        bool isOpen = !_closed.Contains(pointer);
        rows.Add(new(pointer, SessionTexts.Of($"outliner.{kind}"), count, "", 0, "", "") { IsHeading = true, IsOpen = isOpen, Toggle = Toggle });
        foreach (OutlineNode node in isOpen ? nodes : [])
        {
            Add(rows, kind, icon, node, 1);
        }
    }

    private void Add(List<OutlineRow> rows, string kind, string icon, OutlineNode node, int level)
    {
        bool? isOpen = node.Children.Count == 0 ? null : !_closed.Contains(node.Pointer);
        string about = node.IsLight && kind != "lights" ? $"{SessionTexts.Of("outliner.shines")} · {node.Type}" : node.Type;
        rows.Add(new(node.Pointer, node.Name, about, node.Summary, level, node.Color ?? "", IconOf(icon, node)) { IsOpen = isOpen, Toggle = Toggle });
        foreach (OutlineNode child in isOpen == true ? node.Children : [])
        {
            Add(rows, kind, icon, child, level + 1);
        }
    }

    private static string IconOf(string icon, OutlineNode node) => node.Color is null ? SessionCommand.IconOf(icon) : "";

    // One for all rows, so that rows are equal where nothing else differs.
    private RelayCommand<string> Toggle => field ??= new(pointer =>
    {
        if (!_closed.Remove(pointer!))
        {
            _closed.Add(pointer!);
        }

        Build();
    });

    private List<OutlineNode> Filtered(IReadOnlyList<OutlineNode> nodes)
    {
        string wanted = Filter.Trim();
        return wanted.Length == 0 ? [.. nodes] : [.. nodes.Select(n => n with { Children = Filtered(n.Children) })
            .Where(n => n.Children.Count > 0 || $"{n.Name} {n.Type}".Contains(wanted, StringComparison.OrdinalIgnoreCase))];
    }
}

/// <summary>A line of the outliner.</summary>
/// <param name="Pointer">The pointer of its thing.</param>
/// <param name="Name">The name.</param>
/// <param name="About">A word about it.</param>
/// <param name="Tip">A few words about it.</param>
/// <param name="Level">The depth in the tree, from 0.</param>
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

    /// <summary>The indentation in pixels.</summary>
    public double Indent => 14 * Level;

    /// <summary>The direction of the arrow before it.</summary>
    public string Twist => IsOpen == true ? "▾" : "▸";
}

using System.Globalization;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Kept pictures, and what is drawn over the picture.</summary>
internal sealed partial class ViewportViewModel
{
    private static readonly Choice NoComparison = new("", SessionTexts.Of("viewport.noCompare"));
    private Choice _compared;
    private byte[]? _kept;
    private PixelFrame? _outline;
    private (string? Pointer, long Picture, int Revision)? _outlined;
    private Spot? _inspected;
    private Spot? _regionStart;
    private Spot _regionEnd;

    /// <summary>The kept pictures to compare with.</summary>
    public IReadOnlyList<Choice> Comparisons { get; private set; }

    /// <summary>Whether there are kept pictures.</summary>
    public bool HasComparisons => Comparisons.Count > 1;

    /// <summary>The kept picture that lies over the newest one.</summary>
    public Choice? Compared
    {
        get => _compared;
        set
        {
            if (!IsTelling && value is not null && Set(ref _compared, value))
            {
                _ = LoadKept(value);
            }
        }
    }

    /// <summary>The kept picture as a PNG file; null for none.</summary>
    public byte[]? Kept
    {
        get => _kept;
        private set
        {
            if (Set(ref _kept, value))
            {
                Tell(nameof(IsWiping));
                Tell(nameof(WipeBox));
            }
        }
    }

    /// <summary>Whether a kept picture is shown.</summary>
    public bool IsWiping => _kept is not null;

    /// <summary>How much of the kept picture is shown, from the left: 0 to 1.</summary>
    public double Wipe
    {
        get => _wipe;
        set
        {
            if (Set(ref _wipe, Math.Clamp(value, 0, 1)))
            {
                Tell(nameof(WipeBox));
            }
        }
    }

    /// <summary>Where the kept picture is shown.</summary>
    public Box WipeBox => IsWiping ? Place with { Width = Place.Width * _wipe } : Box.None;

    /// <summary>The outline of the selected thing; null for none.</summary>
    public PixelFrame? Outline
    {
        get => _outline;
        private set => Set(ref _outline, value);
    }

    /// <summary>The part that is rendered, or that is being drawn.</summary>
    public Box Region => _regionStart is { } start ? (_stage.Between(start, _regionEnd) is { } drawn ? _stage.ToScreen(drawn) : Box.None)
        : _state?.Settings.Region is { } region ? _stage.ToScreen(region) : Box.None;

    /// <summary>The pixel that is looked into.</summary>
    public Spot? Inspected
    {
        get => _inspected;
        set
        {
            if (Set(ref _inspected, value))
            {
                Tell(nameof(Mark));
                Tell(nameof(MarkText));
            }
        }
    }

    /// <summary>Where it is.</summary>
    public Box Mark => _inspected is { } pixel && _tool == Tool.Inspect ? _stage.ToScreen(new Rendering.Tile((int)pixel.X, (int)pixel.Y, 1, 1)) : Box.None;

    /// <summary>What is written beside it.</summary>
    public string MarkText => _inspected is { } pixel ? SessionTexts.Of("viewport.inspected", (int)pixel.X, (int)pixel.Y) : "";

    /// <summary>Keeps the picture, and compares later ones with it.</summary>
    public void Keep() => _ = _hand.Attempt(async () =>
    {
        Snapshot kept = await _hand.Aside(s => s.Snapshots.Take());
        Choice choice = new(kept.Id.ToString(CultureInfo.InvariantCulture), kept.Label);
        if (!Comparisons.Contains(choice))
        {
            ShowChoices([.. Comparisons, choice]);
        }

        Compared = choice;
    });

    private void ShowSnapshots(IReadOnlyList<Snapshot> snapshots)
    {
        Choice[] choices = [NoComparison, .. snapshots.Select(s => new Choice(s.Id.ToString(CultureInfo.InvariantCulture), s.Label))];
        if (!choices.SequenceEqual(Comparisons))
        {
            ShowChoices(choices);
            Compared = choices.Contains(_compared) ? _compared : NoComparison;
        }
    }

    private void ShowChoices(IReadOnlyList<Choice> choices)
    {
        Comparisons = choices;
        Tell(nameof(Comparisons));
        Tell(nameof(HasComparisons));
    }

    private async Task LoadKept(Choice choice) => await _hand.Attempt(async () =>
        Kept = choice.Value.Length == 0 ? null : await _hand.Ask(s => s.Snapshots.Png(int.Parse(choice.Value, CultureInfo.InvariantCulture))));

    // The outline is found anew where another thing is selected, or it may look otherwise.
    private async Task FollowSelection(SessionState state)
    {
        string? pointer = state.Selection is { } p && SceneThings.IsSeen(p) ? p : null;
        (long picture, int revision) = await _hand.Ask(s => (s.View.Shown?.Picture ?? 0, state.Document.BuiltRevision));
        if (_outlined == (pointer, picture, revision))
        {
            return;
        }

        _outlined = (pointer, picture, revision);
        PixelFrame? outline = pointer is null ? null : await _hand.Aside(s => Task.FromResult(s.View.Shown is { } shown ? SelectionOutline.Of(Picking.Mask(shown, pointer)) : null));
        if (_outlined == (pointer, picture, revision))
        {
            Outline = outline;
            await FollowHandles();
        }
    }

    private Task FollowHandles() => Gizmo.Follow(_state?.Selection, Tool switch { Tool.Move => GizmoKind.Move, Tool.Rotate => GizmoKind.Rotate, Tool.Scale => GizmoKind.Scale, _ => null }, _stage);
}

using System.Globalization;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Kept pictures, and what is drawn over the picture.</summary>
internal sealed partial class ViewportViewModel
{
    private static readonly Choice NoComparison = new("", SessionTexts.Of("viewport.noCompare"));
    private Choice _compared = NoComparison;
    private (string? Pointer, long Picture, int Revision)? _outlined;
    private Spot? _regionStart;
    private Spot _regionEnd;

    /// <summary>The kept pictures to compare with.</summary>
    public IReadOnlyList<Choice> Comparisons { get; private set; } = [NoComparison];

    public bool HasComparisons => Comparisons.Count > 1;

    /// <summary>The kept picture that lies over the newest one.</summary>
    public Choice? Compared
    {
        get => _compared;
        set
        {
            if (!IsReporting && value is not null && SetProperty(ref _compared, value))
            {
                _ = LoadKept(value);
            }
        }
    }

    /// <summary>The kept picture as a PNG file; null for none.</summary>
    public byte[]? Kept
    {
        get;
        private set
        {
            if (SetProperty(ref field, value))
            {
                Report(nameof(IsWiping), nameof(WipeBox));
            }
        }
    }

    /// <summary>Returns whether a kept picture is shown.</summary>
    public bool IsWiping => Kept is not null;

    /// <summary>The part of the kept picture that is shown, from the left: 0 to 1.</summary>
    public double Wipe
    {
        get;
        set
        {
            if (SetProperty(ref field, Math.Clamp(value, 0, 1)))
            {
                OnPropertyChanged(nameof(WipeBox));
            }
        }
    } = 0.5;

    /// <summary>The place of the kept picture.</summary>
    public Box WipeBox => IsWiping ? Place with { Width = Place.Width * Wipe } : Box.None;

    /// <summary>The outline of the selected thing; null for none.</summary>
    public PixelFrame? Outline { get; private set => SetProperty(ref field, value); }

    /// <summary>The part that is rendered, or that is being drawn.</summary>
    public Box Region => _regionStart is { } start ? (Stage.Between(start, _regionEnd) is { } drawn ? Stage.ToScreen(drawn) : Box.None)
        : _state?.Settings.Region is { } region ? Stage.ToScreen(region) : Box.None;

    /// <summary>The pixel that is looked into.</summary>
    public Spot? Inspected
    {
        get;
        set
        {
            if (SetProperty(ref field, value))
            {
                Report(nameof(Mark), nameof(MarkText));
            }
        }
    }

    /// <summary>The place of the inspected pixel.</summary>
    public Box Mark =>
        Inspected is { } pixel && Tool == Tool.Inspect ? Stage.ToScreen(new Rendering.Tile((int)pixel.X, (int)pixel.Y, 1, 1)) : Box.None;

    /// <summary>The text beside it.</summary>
    public string MarkText => Inspected is { } pixel ? SessionTexts.Of("viewport.inspected", (int)pixel.X, (int)pixel.Y) : "";

    /// <summary>Keeps the picture, and compares later ones with it.</summary>
    public void Keep() => _ = dispatcher.Attempt(async () =>
    {
        Snapshot kept = await dispatcher.Aside(s => s.Snapshots.Capture());
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
        Report(nameof(Comparisons), nameof(HasComparisons));
    }

    private async Task LoadKept(Choice choice) => await dispatcher.Attempt(async () =>
        Kept = choice.Value.Length == 0 ? null : await dispatcher.Ask(s => s.Snapshots.Png(int.Parse(choice.Value, CultureInfo.InvariantCulture))));

    // The outline is found again where another thing is selected, or it may look otherwise.
    private async Task FollowSelection(SessionState state)
    {
        string? pointer = state.Selection is { } p && SceneThings.IsSeen(p) ? p : null;
        (long picture, int revision) = await dispatcher.Ask(s => (s.View.Shown?.Picture ?? 0, state.Document.BuiltRevision));
        if (_outlined == (pointer, picture, revision))
        {
            return;
        }

        _outlined = (pointer, picture, revision);
        PixelFrame? outline = pointer is null ? null : await dispatcher.Aside(s => Task.FromResult(s.View.Shown is { } shown ? SelectionOutline.Of(Picking.Mask(shown, pointer)) : null));
        if (_outlined == (pointer, picture, revision))
        {
            Outline = outline;
            await FollowHandles();
        }
    }

    private Task FollowHandles() => Gizmo.Follow(_state?.Selection, Tool switch { Tool.Move => GizmoKind.Move, Tool.Rotate => GizmoKind.Rotate, Tool.Scale => GizmoKind.Scale, _ => null }, Stage);
}

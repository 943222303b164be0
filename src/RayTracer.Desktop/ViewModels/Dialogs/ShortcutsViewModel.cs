using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>All keys on one sheet.</summary>
internal sealed class ShortcutsViewModel : DialogViewModel
{
    /// <inheritdoc/>
    public override string Title => SessionTexts.Of("shortcuts.title");

    /// <inheritdoc/>
    public override string CancelText => SessionTexts.Of("dialogs.close");

    /// <summary>The keys in groups.</summary>
    public IReadOnlyList<ShortcutGroup> Groups { get; } =
    [
        .. SessionCommand.All.Where(c => c.Keys is not null).GroupBy(c => c.Group)
            .Select(g => new ShortcutGroup(SessionTexts.Of($"groups.{g.Key}"), [.. g.Select(c => new ShortcutRow(c.Name, c.KeysText!))])),
        new(SessionTexts.Of("shortcuts.mouse"), [.. Enumerable.Range(0, SessionTexts.Count("shortcuts.gestures"))
            .Select(i => new ShortcutRow(SessionTexts.Of($"shortcuts.gestures.{i}.1"), SessionTexts.Of($"shortcuts.gestures.{i}.0")))]),
    ];
}

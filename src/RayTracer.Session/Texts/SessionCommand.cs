using System.Text.Json.Nodes;

namespace RayTracer.Session;

/// <summary>Something that a menu, a button or a key can do, whatever shows it.</summary>
/// <param name="Id">Its name in programs.</param>
/// <param name="Name">The name.</param>
/// <param name="Tip">Its purpose.</param>
/// <param name="Group">The key of its group's name among the texts.</param>
/// <param name="Keys">
/// Its shortcut, as browsers call keys, with "Mod+", "Shift+" and "Alt+" before it; null where it has none. Mod is Ctrl, or Command on a
/// Mac.
/// </param>
/// <param name="Icon">Its icon's lines in a square of 16 × 16, as SVG paths are written; null where it has none.</param>
public sealed record SessionCommand(string Id, string Name, string Tip, string Group, string? Keys, string? Icon)
{
    private static readonly JsonObject Icons = SessionTexts.Read("icons");

    /// <summary>All commands, but those that only the Studio's pages have. They are built with the same list.</summary>
    public static IReadOnlyList<SessionCommand> All { get; } =
        [.. SessionTexts.Read("commands").Where(c => c.Value!["pages"] is null).Select(c => Of(c.Key, c.Value!.AsObject()))];

    /// <summary>An icon's lines.</summary>
    /// <exception cref="KeyNotFoundException">There is no such icon.</exception>
    public static string IconOf(string name) =>
        Icons[name]?.GetValue<string>() ?? throw new KeyNotFoundException($"There is no icon {name}.");

    /// <summary>"Mod+Shift+S" as it is printed on keyboards; null where there are no keys.</summary>
    public string? KeysText => Keys is null ? null : string.Join('+', Keys.Split('+').Select(Printed));

    /// <summary>Returns whether a press of keys means the command. Shift counts by what it makes of the key.</summary>
    /// <param name="key">The key, as browsers call it: a letter as it would be written, "ArrowUp", "Delete" …</param>
    /// <param name="mod">True if Ctrl (on a Mac: Command) is held.</param>
    /// <param name="shift">True if Shift is held.</param>
    /// <param name="alt">True if Alt is held.</param>
    public bool IsPressed(string key, bool mod, bool shift, bool alt)
    {
        string[] parts = Keys?.Split('+') ?? [];
        return parts.Length > 0 && mod == parts.Contains("Mod") && alt == parts.Contains("Alt") && (shift == parts.Contains("Shift") || key == "?")
            && key.Equals(parts[^1], StringComparison.OrdinalIgnoreCase);
    }

    private static string Printed(string key) => key switch
    {
        "ArrowUp" => "↑",
        "ArrowDown" => "↓",
        "Mod" => OperatingSystem.IsMacOS() ? "⌘" : "Ctrl",
        "Delete" => "Del",
        "Escape" => "Esc",
        _ => key.Length == 1 ? key.ToUpperInvariant() : key,
    };

    private static SessionCommand Of(string id, JsonObject about) => new(
        id, SessionTexts.Of($"commands.{id}.0"), SessionTexts.Of($"commands.{id}.1"), about["group"]!.GetValue<string>(), about["keys"]?.GetValue<string>(),
        about["icon"]?.GetValue<string>() is { } icon ? IconOf(icon) : null);
}

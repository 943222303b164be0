using System.Globalization;
using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Work of an earlier session that was not saved.</summary>
internal sealed class RecoveryViewModel(RecoveryEntry entry, Action open, Action discard)
{
    /// <summary>How the session calls it.</summary>
    public string Id => entry.Id;

    /// <summary>What there is.</summary>
    public string Text => SessionTexts.Of("recovery.text", entry.Name, entry.Time.ToLocalTime().ToString("yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture));

    /// <summary>Opens it.</summary>
    public ICommand Open { get; } = new ActionCommand(open);

    /// <summary>Throws it away.</summary>
    public ICommand Discard { get; } = new ActionCommand(discard);
}

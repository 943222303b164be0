using System.Windows.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A short message that can be dismissed.</summary>
internal sealed class MessageViewModel(string kind, string text, Action<MessageViewModel> dismiss)
{
    /// <summary>What it tells.</summary>
    public string Text => text;

    /// <summary>Whether something went wrong.</summary>
    public bool IsError => kind == "error";

    /// <summary>Takes it away.</summary>
    public ICommand Dismiss => new ActionCommand(() => dismiss(this));
}

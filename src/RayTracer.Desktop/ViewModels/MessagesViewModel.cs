using System.Collections.ObjectModel;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Short messages over the window.</summary>
internal sealed class MessagesViewModel
{
    private const int ShownAtOnce = 4;
    private static readonly TimeSpan InfoStaysFor = TimeSpan.FromSeconds(6);

    /// <summary>Those that are shown, the oldest first.</summary>
    public ObservableCollection<MessageViewModel> All { get; } = [];

    /// <summary>Shows one; the same text only once.</summary>
    /// <param name="kind">"info", which goes by itself, or "error".</param>
    /// <param name="text">The message.</param>
    public void Say(string kind, string text)
    {
        if (All.FirstOrDefault(m => m.Text == text) is { } same)
        {
            All.Remove(same);
        }

        MessageViewModel message = new(kind, text, m => All.Remove(m));
        All.Add(message);
        if (All.Count > ShownAtOnce)
        {
            All.RemoveAt(0);
        }

        if (!message.IsError)
        {
            _ = Fade(message);
        }
    }

    private async Task Fade(MessageViewModel message)
    {
        await Task.Delay(InfoStaysFor);
        All.Remove(message);
    }
}

/// <summary>A short message that can be dismissed.</summary>
internal sealed class MessageViewModel(string kind, string text, Action<MessageViewModel> dismiss)
{
    public string Text => text;

    public bool IsError => kind == "error";

    /// <summary>Takes it away.</summary>
    public ICommand Dismiss => new RelayCommand(() => dismiss(this));
}

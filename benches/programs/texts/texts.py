def main():
    text, length = "", 0
    for i in range(1, 2000001):
        text = text + "ab"
        text = text + str(i)
        if len(text) > 100:
            length = length + len(text)
            text = ""
    print(length)


main()
